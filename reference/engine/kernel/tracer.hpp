// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

template <class V>
struct Ray {
  Vec3<V> origin;
  Vec3<V> direction;  ///< unit
  /// The place of the surface that the ray leaves, or -1, and whether it leaves a sphere inwards: this says whether the ray
  /// may meet its own surface again; no epsilon anywhere (D6).
  IndexOf<V> leaves;
  MaskOf<V> inwards;
};

/// The nearest surface that a ray meets.
template <class V>
struct Nearest {
  V t;               ///< infinity: nothing
  IndexOf<V> place;  ///< of the surface; -1: nothing
};

/// A surface point that a ray has reached.
template <class V>
struct Hit {
  Vec3<V> point;
  Vec3<V> normal;  ///< unit, turned to the ray's side
  IndexOf<V> place;
  MaskOf<V> inside;  ///< met from the inside of a sphere
  Vec3<V> center;    ///< of the sphere
  V radius;
};

/// Which surface each lane has met; most packs see but one, and need not gather.
template <class V>
class Places {
 public:
  Places(IndexOf<V> place, MaskOf<V> lanes) {
    std::array<WholeOf<V>, Lanes<V>::count> places;
    store(place, places.data());
    common_ = places[static_cast<std::size_t>(std::countr_zero(bits(lanes)))];
    same_ = none(lanes & !(place == IndexOf<V>(common_)));
    each_ = select(lanes, place, IndexOf<V>(common_));
  }

  bool same() const { return same_; }
  std::size_t common() const { return static_cast<std::size_t>(common_); }
  IndexOf<V> each() const { return each_; }

 private:
  IndexOf<V> each_;
  WholeOf<V> common_;
  bool same_;
};

/// What the surfaces are like that the lanes have met.
template <class V>
struct Look {
  Vec3<V> color;
  V alpha, strength, mirror;
  MaskOf<V> glass;
  IndexOf<V> finish_row;
};

/// The rays that wait, the last come first. They are large, so they stay where they are put: what moves are their numbers.
template <class Waiting>
class WaitingRays {
 public:
  WaitingRays() {
    for (std::size_t i = 0; i < most; ++i) free_[i] = static_cast<std::uint8_t>(i);
  }

  bool empty() const { return size_ == 0; }

  /// To be filled in.
  Waiting& push() {
    const std::uint8_t place = free_[size_ + held_];
    order_[size_++] = place;
    return rays_[place];
  }

  /// Valid until release().
  const Waiting& pop() {
    ++held_;
    return rays_[order_[--size_]];
  }

  void release(const Waiting& rays) {
    --held_;
    free_[size_ + held_] = static_cast<std::uint8_t>(&rays - rays_.data());
  }

 private:
  static constexpr std::size_t most = most_bounces + 2;

  std::array<Waiting, most> rays_;
  std::array<std::uint8_t, most> order_, free_;  // of free_, the places from size_ + held_ on
  std::size_t size_ = 0, held_ = 0;
};

/// Follows the rays of a few pixels at a time, one in each lane, through a prepared scene. Lanes never mix: what one holds
/// does not depend on the others, nor on how many there are. One for each call of trace_rows: it holds the rays that wait,
/// the counts, and nothing that one pixel could pass on to the next.
template <class V>
class Tracer {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;

  Tracer(const Prepared<T>& scene, RayCounts& counts, const std::atomic<bool>& cancel)
      : scene_(scene), plane_count_(static_cast<Whole>(scene.planes.point.size())), counts_(counts), cancel_(cancel) {
    std::array<T, Lanes<V>::count> x, y;
    for (int lane = 0; lane < Lanes<V>::count; ++lane) {
      x[static_cast<std::size_t>(lane)] = static_cast<T>(lane % Tile::width);
      y[static_cast<std::size_t>(lane)] = static_cast<T>(lane / Tile::width);
    }
    tile_x_ = load<V>(x.data());
    tile_y_ = load<V>(y.data());
    all_ = tile_x_ >= V(0);
  }

  /// Whole rows, as Engine::trace_rows says.
  void rows(int first_row, std::span<Color> pixels) {
    const int width = scene_.settings.size.width;
    const int height = static_cast<int>(pixels.size() / static_cast<std::size_t>(width));
    for (int row = 0; row < height; row += Tile::height)
      for (int column = 0; column < width; column += Tile::width) {
        const int columns = std::min(Tile::width, width - column), rows = std::min(Tile::height, height - row);
        Color* const corner =
            &pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
        write(tile(column, first_row + row, columns, rows), columns, rows, corner);
      }
  }

 private:
  using Whole = WholeOf<V>;
  using Row = SingleOf<V>;  ///< spheres side by side, that one ray or beam asks

  /// The pixels that are traced together: a block, whose rays stay together longer than those of a row.
  struct Tile {
    static constexpr int width = Lanes<V>::count >= 32 ? 8 : Lanes<V>::count >= 8 ? 4 : Lanes<V>::count >= 2 ? 2 : 1;
    static constexpr int height = Lanes<V>::count / width;
  };

  /// A ray to be traced in each lane of `lanes`, and how much of its color reaches the pixel.
  struct Waiting {
    Ray<V> ray;
    V weight;
    Mask lanes;
    int bounce;
  };

  /// The colors of a tile whose top left pixel is at (column, row) of the image.
  Vec3<V> tile(int column, int row, int columns, int rows) {
    // Halves of whole numbers: exact in any T.
    const ImageSize size = scene_.settings.size;
    const V x = V(static_cast<T>(column) + T(0.5) - T(0.5) * static_cast<T>(size.width)) + tile_x_;
    const V y = V(T(0.5) * static_cast<T>(size.height) - static_cast<T>(row) - T(0.5)) - tile_y_;
    Mask inside = all_;
    if (columns < Tile::width || rows < Tile::height)
      inside = (tile_x_ < V(static_cast<T>(columns))) & (tile_y_ < V(static_cast<T>(rows)));
    return pixel(x, y, inside);
  }

  void write(const Vec3<V>& color, int columns, int rows, Color* corner) const {
    std::array<double, 3 * Lanes<V>::count> numbers;
    store_interleaved(clamped(color.x), clamped(color.y), clamped(color.z), numbers.data());
    for (int row = 0; row < rows; ++row, corner += scene_.settings.size.width) {
      static_assert(sizeof(Color) == 3 * sizeof(double));
      const double* const first = &numbers[static_cast<std::size_t>(3 * row * Tile::width)];
      if (columns == Tile::width)
        std::memcpy(static_cast<void*>(corner), first, Tile::width * sizeof(Color));
      else
        std::memcpy(static_cast<void*>(corner), first, static_cast<std::size_t>(columns) * sizeof(Color));
    }
  }

  static Vec3<V> zero() { return {V(0), V(0), V(0)}; }

  /// A NaN stays one: the program counts and reports it.
  static V clamped(V c) { return select(c < V(0), V(0), select(c > V(1), V(1), c)); }

  /// The mean of the samples of the pixels whose centres are at (x, y), not yet clamped.
  Vec3<V> pixel(V x, V y, Mask lanes) {
    if (scene_.adaptive) return adaptive_pixel(x, y, lanes);
    Vec3<V> sum = zero();
    for (const SampleOffset& offset : scene_.samples) sum = sum + sample(x, y, offset, lanes);
    return V(T(1) / static_cast<T>(scene_.samples.size())) * sum;
  }

  Vec3<V> sample(V x, V y, const SampleOffset& offset, Mask lanes) {
    return primary(x + V(static_cast<T>(offset.dx)), y + V(static_cast<T>(offset.dy)), lanes);
  }

  Vec3<V> adaptive_pixel(V x, V y, Mask lanes) {
    Vec3<V> sum = zero(), least_seen = {V(1), V(1), V(1)}, greatest_seen = zero();
    Mask agreed = lanes;
    for (std::size_t k = 0; k < deciding_samples; ++k) {
      const Vec3<V> color = sample(x, y, scene_.samples[k], lanes);
      sum = sum + color;
      const Vec3<V> seen = {clamped(color.x), clamped(color.y), clamped(color.z)};
      least_seen = {least(least_seen.x, seen.x), least(least_seen.y, seen.y), least(least_seen.z, seen.z)};
      greatest_seen = {greatest(greatest_seen.x, seen.x), greatest(greatest_seen.y, seen.y),
                       greatest(greatest_seen.z, seen.z)};
      agreed = agreed & (dot(seen, seen) >= V(0));  // and not NaN
    }
    const Vec3<V> apart = greatest_seen - least_seen;
    const V limit(static_cast<T>(agreeing_samples));
    agreed = agreed & (apart.x <= limit) & (apart.y <= limit) & (apart.z <= limit);
    const Mask more = lanes & !agreed;
    const Vec3<V> mean = V(T(1) / static_cast<T>(deciding_samples)) * sum;
    if (none(more)) return mean;
    const Vec3<V> refined = V(T(1) / static_cast<T>(scene_.samples.size())) * with_the_rest(x, y, more, sum);
    return select(more, refined, mean);
  }

  /// Adds the samples that did not decide. Pixels that need them are few and far between, so that most lanes of a pack would
  /// be idle: the samples are lined up in new packs instead, pixel by pixel.
  Vec3<V> with_the_rest(V x, V y, Mask pixels, const Vec3<V>& sum) {
    constexpr std::size_t rest = adaptive_samples - deciding_samples, lanes = Lanes<V>::count;
    std::array<T, lanes> x_of, y_of;
    store(x, x_of.data());
    store(y, y_of.data());
    std::array<T, (rest + 1) * lanes> xs{}, ys{};
    std::size_t count = 0;
    for (std::uint32_t left = bits(pixels); left != 0; left &= left - 1)
      for (std::size_t k = deciding_samples; k < scene_.samples.size(); ++k, ++count) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        xs[count] = x_of[lane] + static_cast<T>(scene_.samples[k].dx);
        ys[count] = y_of[lane] + static_cast<T>(scene_.samples[k].dy);
      }
    std::array<std::array<T, (rest + 1) * lanes>, 3> colors;
    for (std::size_t i = 0; i < count; i += lanes) {
      const std::uint32_t there =
          count - i >= lanes ? static_cast<std::uint32_t>((1ull << lanes) - 1) : (1u << (count - i)) - 1;
      const Vec3<V> color = primary(load<V>(&xs[i]), load<V>(&ys[i]), mask_of<V>(there));
      store(color.x, &colors[0][i]);
      store(color.y, &colors[1][i]);
      store(color.z, &colors[2][i]);
    }
    return {added(sum.x, colors[0], bits(pixels)), added(sum.y, colors[1], bits(pixels)),
            added(sum.z, colors[2], bits(pixels))};
  }

  template <std::size_t most>
  V added(V sum, const std::array<T, most>& numbers, std::uint32_t pixels) const {
    std::array<T, Lanes<V>::count> sums;
    store(sum, sums.data());
    for (std::size_t i = 0; pixels != 0; pixels &= pixels - 1)
      for (std::size_t k = deciding_samples; k < scene_.samples.size(); ++k)
        sums[static_cast<std::size_t>(std::countr_zero(pixels))] += numbers[i++];
    return load<V>(sums.data());
  }

  Vec3<V> primary(V x, V y, Mask lanes) {
    add(lanes, counts_.primary);
    const PreparedCamera<T>& camera = scene_.camera;
    const Vec3<V> towards = spread<V>(camera.forward) + x * spread<V>(camera.right) + y * spread<V>(camera.up);
    const Vec3<V> d = (V(1) / square_root(dot(towards, towards))) * towards;
    if (scene_.settings.stage == 1) return V(T(0.5)) * (d + Vec3<V>{V(1), V(1), V(1)});
    return color({spread<V>(camera.position), d, Index(-1), mask_of<V>(0)}, lanes);
  }

  /// The color at the end of primary rays. Glass splits a ray in two: those to come wait on a stack, which never holds more
  /// than one for each bounce.
  Vec3<V> color(const Ray<V>& primary_rays, Mask lanes) {
    Vec3<V> sum = zero();
    wait(primary_rays, V(1), lanes, 0);
    while (!waiting_.empty()) {
      const Waiting& next = waiting_.pop();
      sum = select(next.lanes, sum + next.weight * surface_color(next), sum);
      waiting_.release(next);
    }
    return sum;
  }

  /// The color that the nearest surface itself sends back; the rays that it sends on are added to those that wait.
  Vec3<V> surface_color(const Waiting& from) {
    if (cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
    const Nearest<V> nearest = nearest_surface(from.ray, from.lanes);
    const Mask met = from.lanes & (nearest.place >= Index(0));
    const Vec3<V> background = spread<V>(scene_.background);
    if (none(met)) return background;
    const Places<V> places(nearest.place, met);
    const Look<V> look = look_at(places);
    if (scene_.settings.stage == 2) return select(met, look.color, background);
    const Hit<V> hit = hit_at(from.ray, nearest, places, met);
    const Mask glass = met & look.glass;
    const Mask lit = met & !glass;
    send_on(from, hit, look, met, glass);
    const Vec3<V> seen = any(lit) ? tinted(light_on(hit, from.ray.direction, look, lit), look.color) : zero();
    return select(lit, seen, select(glass, zero(), background));
  }

  Look<V> look_at(const Places<V>& places) const {
    const T* const surfaces = scene_.surfaces.numbers.data();
    const T* const finishes = scene_.finishes.numbers.data();
    if (places.same()) {
      const T* const surface = surfaces + places.common() * surface_columns;
      const Whole row = static_cast<Whole>(surface[finish]) * finish_columns;
      const T* const look = finishes + row;
      return {{V(surface[red]), V(surface[green]), V(surface[blue])},
              V(look[alpha]),
              V(look[strength]),
              V(look[mirror]),
              V(look[is_glass]) > V(0),
              Index(row)};
    }
    const Index surface = shifted_left<std::countr_zero(unsigned{surface_columns})>(places.each());
    const Index row = shifted_left<std::countr_zero(unsigned{finish_columns})>(whole(gather(surfaces + finish, surface)));
    return {{gather(surfaces + red, surface), gather(surfaces + green, surface), gather(surfaces + blue, surface)},
            gather(finishes + alpha, row),
            gather(finishes + strength, row),
            gather(finishes + mirror, row),
            gather(finishes + is_glass, row) > V(0),
            row};
  }

  // ---- What the rays of a pack have in common -----------------------------------------------------------------------

  /// A ball around points: within `radius` of the one in lane `first`.
  struct Area {
    std::size_t first;
    Point<T> middle;
    T radius;
  };

  /// All that is within a distance of a segment, which is `radius` where that starts, and grows.
  struct Beam {
    Point<T> origin, direction;
    T radius;
    T growth;  ///< for each unit of length
    T length;
  };

  /// A light as points see it.
  struct Seen {
    Vec3<V> l;  ///< unit, towards the light
    V distance;
    const Sides& sides;
  };

  static T lane(V a, std::size_t i) {
    std::array<T, Lanes<V>::count> numbers;
    store(a, numbers.data());
    return numbers[i];
  }

  static Point<T> lane(const Vec3<V>& a, std::size_t i) { return {lane(a.x, i), lane(a.y, i), lane(a.z, i)}; }

  static T greatest_distance(const Vec3<V>& from, const Point<T>& to, Mask lanes) {
    const Vec3<V> apart = from - spread<V>(to);
    return std::sqrt(greatest_lane(select(lanes, dot(apart, apart), V(0))));
  }

  static Area area_of(const Vec3<V>& points, Mask lanes) {
    // One from the middle of the tile, if there is one.
    constexpr std::uint32_t inner = Lanes<V>::count == 32   ? 0x3c3c00
                                    : Lanes<V>::count == 16 ? 0x0660
                                    : Lanes<V>::count == 8  ? 0x66
                                                            : ~0u;
    const std::uint32_t all = bits(lanes);
    const auto first = static_cast<std::size_t>(std::countr_zero((all & inner) != 0 ? all & inner : all));
    const Point<T> middle = lane(points, first);
    return {first, middle, greatest_distance(points, middle, lanes)};
  }

  static Beam beam_of(const Ray<V>& ray, Mask lanes, V limit) {
    const Area start = area_of(ray.origin, lanes);
    const Point<T> direction = lane(ray.direction, start.first);
    return {start.middle, direction, start.radius, greatest_distance(ray.direction, direction, lanes),
            greatest_lane(select(lanes, limit, V(0)))};
  }

  /// Of shadow rays: they start in a ball and end in a point, or run in parallel. `first` may be a lane whose light is so
  /// near that it is in no direction; then there is only the ball.
  static Beam beam_of(const Area& area, const Seen& light) {
    Beam beam = {area.middle, lane(light.l, area.first), area.radius, 0, lane(light.distance, area.first)};
    const auto [x, y, z] = beam.direction;
    if (!(x * x + y * y + z * z < T(2))) beam.direction = {};
    return beam;
  }

  /// Bit k: may a ray of the beam meet sphere begin + k, before `end`? A hit is at most 2 (R + radius) / (1 - growth)
  /// further along than the sphere's centre, and a beam that grows faster than this reaches everything.
  static constexpr T fastest_growth = T(0.25);

  std::uint32_t reached(const Beam& beam, std::size_t begin, std::size_t end) const {
    constexpr T rounding = 64 * std::numeric_limits<T>::epsilon();
    const Spheres<T>& spheres = scene_.spheres;
    const std::size_t left = end - begin;
    const std::uint32_t there = left >= 32 ? ~0u : (1u << left) - 1;
    const Vec3<Row> c = {load<Row>(&spheres.center.x[begin]), load<Row>(&spheres.center.y[begin]),
                         load<Row>(&spheres.center.z[begin])};
    const Vec3<Row> direction = spread<Row>(beam.direction);
    const Vec3<Row> f = c - spread<Row>(beam.origin);
    const Row along = least(greatest(dot(f, direction), Row(0)), Row(beam.length));
    const Vec3<Row> apart = f - along * direction;
    const Row radius = Row(T(1.001) + 3 * beam.growth) * (load<Row>(&spheres.radius[begin]) + Row(beam.radius)) +
                       Row(rounding + T(1.5) * beam.growth) * along;
    return bits(!(dot(apart, apart) > radius * radius)) & there;
  }

  /// Calls visit(i) for the spheres from `begin` up to `end` that the beam reaches, until it returns false.
  template <class Visit>
  RAYLAB_INLINE void for_each_reached(const Beam& beam, std::size_t begin, std::size_t end, Visit visit) const {
    if (Lanes<V>::count == 1 || !(beam.growth < fastest_growth)) {
      for (std::size_t i = begin; i < end; ++i)
        if (!visit(i)) return;
      return;
    }
    for (std::size_t i = begin; i < end; i += Lanes<Row>::count)
      for (std::uint32_t near = reached(beam, i, end); near != 0; near &= near - 1)
        if (!visit(i + static_cast<std::size_t>(std::countr_zero(near)))) return;
  }

  /// A hierarchy is searched for the rays of a pack together where they are some, and stay together; if they turn out to
  /// meet too many leaves, or are few, for each of them alone.
  static constexpr std::size_t least_together = 6;
  static constexpr T widest_together = T(0.1);
  static constexpr int most_leaves_together = 6;

  static Probes<1> probe_for(const Beam& beam, const Hierarchy& hierarchy) {
    const auto [x, y, z] = beam.origin;
    const auto [a, b, c] = beam.direction;
    const std::array<double, 3>& middle = hierarchy.middle();
    const double to_middle = std::max({std::abs(x - middle[0]), std::abs(y - middle[1]), std::abs(z - middle[2])});
    const double farthest = std::min<double>(beam.length, 2 * (to_middle + hierarchy.extent()));
    return {hierarchy, Probes<1>::Vectors<T>{{{x}, {y}, {z}}}, {{{a}, {b}, {c}}}, beam.radius + beam.growth * farthest};
  }

  // ---- Intersections ------------------------------------------------------------------------------------------------

  Nearest<V> nearest_surface(const Ray<V>& ray, Mask lanes) {
    Nearest<V> best = {V(std::numeric_limits<T>::infinity()), Index(-1)};
    for (std::size_t i = 0; i < scene_.planes.point.size(); ++i) {
      const V t =
          plane_distance(ray.origin, ray.direction, spread<V>(scene_.planes.point[i]), spread<V>(scene_.planes.normal[i]));
      const Index place(static_cast<Whole>(i));
      const Mask closer = lanes & (t >= V(0)) & (t < best.t) & !(ray.leaves == place);
      best.t = select(closer, t, best.t);
      best.place = select(closer, place, best.place);
    }
    if (any(ray.inwards)) meet_own_sphere(ray, lanes & ray.inwards, best);
    if (scene_.spheres.count > 0) nearest_sphere(ray, lanes, best);
    return best;
  }

  /// To ask so many is faster than to find out which ones a beam reaches.
  static constexpr std::size_t few_spheres = 8;

  void nearest_sphere(const Ray<V>& ray, Mask lanes, Nearest<V>& best) const {
    if (scene_.spheres.count <= few_spheres) {
      for (const SphereGroup* group : {&scene_.spheres.opaque, &scene_.spheres.glass})
        for (std::size_t i = group->begin; i < group->loop_end; ++i) meet_sphere(ray, lanes, i, best);
      return;
    }
    const Beam beam = beam_of(ray, lanes, best.t);
    for (const SphereGroup* group : {&scene_.spheres.opaque, &scene_.spheres.glass}) {
      for_each_reached(beam, group->begin, group->loop_end, [&](std::size_t i) RAYLAB_ATTRIBUTE {
        meet_sphere(ray, lanes, i, best);
        return true;
      });
      if (group->hierarchy) search_nearest(ray, lanes, beam, *group, best);
    }
  }

  /// The place in Spheres of each lane's sphere; 0 in the lanes that have none.
  Index sphere_of(Index place, Mask lanes) const {
    return select(lanes & (place >= Index(plane_count_)), place - Index(plane_count_), Index(0));
  }

  Vec3<V> centers(Index sphere) const {
    const PointArray<T>& center = scene_.spheres.center;
    return {gather(center.x.data(), sphere), gather(center.y.data(), sphere), gather(center.z.data(), sphere)};
  }

  Vec3<V> center(std::size_t i) const { return spread<V>(scene_.spheres.center[i]); }

  void meet_own_sphere(const Ray<V>& ray, Mask lanes, Nearest<V>& best) const {
    const V t = far_side(pass(ray.origin, ray.direction, centers(sphere_of(ray.leaves, lanes))));
    update(lanes, t, ray.leaves, best);
  }

  /// Lanes whose line passes sphere i closely enough, but for those that leave it, that have it behind them, or that have
  /// met something nearer for certain.
  RAYLAB_INLINE Mask may_meet(Index leaves, Mask lanes, std::size_t i, const Passing<V>& passing, V limit) const {
    const V reach(scene_.spheres.reach[i]);
    const Mask close = lanes & (passing.apart <= reach);
    if (none(close)) return close;
    const V radius(scene_.spheres.radius[i] * (1 + 256 * std::numeric_limits<T>::epsilon()));
    const Mask ahead = (passing.b < V(0)) | (passing.b * passing.b + passing.apart <= reach);
    return close & ahead & (-passing.b - radius <= limit) & !(leaves == place_of(i));
  }

  Index place_of(std::size_t sphere) const { return Index(plane_count_ + static_cast<Whole>(sphere)); }

  RAYLAB_INLINE void meet_sphere(const Ray<V>& ray, Mask lanes, std::size_t i, Nearest<V>& best) const {
    const Passing<V> passing = pass(ray.origin, ray.direction, center(i));
    const Mask asked = may_meet(ray.leaves, lanes, i, passing, best.t);
    if (none(asked)) return;
    const Meeting<V> meeting = meet_one(ray.origin, asked, passing, i);
    update(meeting.met, meeting.t, place_of(i), best);
  }

  RAYLAB_INLINE Meeting<V> meet_one(const Vec3<V>& origin, Mask asked, const Passing<V>& passing, std::size_t i) const {
    const V radius(scene_.spheres.radius[i]);
    return meet(asked, passing, radius, [&]() RAYLAB_ATTRIBUTE { return gap_to_sphere(origin, center(i), radius); });
  }

  /// The nearer one wins; of equal t the one that stands first in the scene (D7).
  void update(Mask met, V t, Index place, Nearest<V>& best) const {
    Mask closer = met & (t < best.t);
    const Mask tied = met & (t == best.t);
    if (any(tied)) [[unlikely]]
      closer = closer | (tied & stands_before(tied, place, best.place));
    best.t = select(closer, t, best.t);
    best.place = select(closer, place, best.place);
  }

  Mask stands_before(Mask lanes, Index a, Index b) const {
    std::array<Whole, Lanes<V>::count> places_a, places_b;
    store(a, places_a.data());
    store(b, places_b.data());
    std::uint32_t before = 0;
    for (std::uint32_t rest = bits(lanes); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      if (id_of(places_a[lane]) < id_of(places_b[lane])) before |= 1u << lane;
    }
    return mask_of<V>(before);
  }

  GeometryId id_of(Whole place) const {
    return place < plane_count_ ? static_cast<GeometryId>(place)
                                : scene_.spheres.id[static_cast<std::size_t>(place - plane_count_)];
  }

  // ---- Many spheres -------------------------------------------------------------------------------------------------

  /// One lane's ray.
  struct Alone {
    Point<T> origin, direction;
    Whole leaves;
  };

  /// Takes rays out of their lanes.
  class Singles {
   public:
    using Probes = raylab::fast::RAYLAB_TARGET::Probes<Lanes<V>::count>;

    explicit Singles(const Ray<V>& ray) {
      store(ray.origin.x, origin_[0].data());
      store(ray.origin.y, origin_[1].data());
      store(ray.origin.z, origin_[2].data());
      store(ray.direction.x, direction_[0].data());
      store(ray.direction.y, direction_[1].data());
      store(ray.direction.z, direction_[2].data());
      store(ray.leaves, leaves_.data());
    }

    Alone ray(std::size_t lane) const {
      return {{origin_[0][lane], origin_[1][lane], origin_[2][lane]},
              {direction_[0][lane], direction_[1][lane], direction_[2][lane]},
              leaves_[lane]};
    }

    Probes probes(const Hierarchy& hierarchy) const { return {hierarchy, origin_, direction_, 0}; }

   private:
    typename Probes::template Vectors<T> origin_, direction_;
    std::array<Whole, Lanes<V>::count> leaves_;
  };

  void search_nearest(const Ray<V>& ray, Mask lanes, const Beam& beam, const SphereGroup& group, Nearest<V>& best) const {
    const auto limit = [&]() RAYLAB_ATTRIBUTE { return as_limit(greatest_lane(select(lanes, best.t, V(-1)))); };
    const auto visit = [&](std::size_t i) RAYLAB_ATTRIBUTE {
      meet_sphere(ray, lanes, i, best);
      return true;
    };
    if (!search_beam(group, beam, lanes, limit, visit)) search_nearest_each(ray, lanes, group, best);
  }

  /// Calls visit(i) for the spheres that the beam of `lanes` reaches, up to limit(), until that is below 0 or visit()
  /// returns false. False: gave up, or did not begin.
  template <class Limit, class Visit>
  RAYLAB_INLINE bool search_beam(const SphereGroup& group, const Beam& beam, Mask lanes, Limit limit, Visit visit) const {
    if (count(lanes) < least_together || !(beam.growth < widest_together)) return false;
    int leaves = most_leaves_together;
    const auto leaf = [&](std::size_t begin, std::size_t count) RAYLAB_ATTRIBUTE {
      for_each_reached(beam, group.loop_end + begin, group.loop_end + begin + count, visit);
      return --leaves > 0 ? limit() : -1.0f;
    };
    search_together(*group.hierarchy, probe_for(beam, *group.hierarchy), limit(), leaf);
    return leaves > 0;
  }

  void search_nearest_each(const Ray<V>& ray, Mask lanes, const SphereGroup& group, Nearest<V>& best) const {
    const Singles rays(ray);
    std::array<T, Lanes<V>::count> t;
    std::array<Whole, Lanes<V>::count> places;
    store(best.t, t.data());
    store(best.place, places.data());
    Limits<Lanes<V>::count> limits = limits_of(bits(lanes), t);
    search_each(*group.hierarchy, rays.probes(*group.hierarchy), bits(lanes), limits,
                [&](std::size_t begin, std::size_t count, std::size_t lane) RAYLAB_ATTRIBUTE {
                  for (std::size_t i = group.loop_end + begin; i < group.loop_end + begin + count; i += Lanes<Row>::count)
                    if (nearer_of_spheres(rays.ray(lane), i, t[lane], places[lane])) limits[lane] = as_limit(t[lane]);
                });
    best.t = load<V>(t.data());
    best.place = load_index<V>(places.data());
  }

  static Limits<Lanes<V>::count> limits_of(std::uint32_t lanes, const std::array<T, Lanes<V>::count>& lengths) {
    Limits<Lanes<V>::count> limits;
    for (std::size_t lane = 0; lane < lengths.size(); ++lane)
      limits[lane] = (lanes >> lane & 1) != 0 ? as_limit(lengths[lane]) : -1.0f;
    return limits;
  }

  /// The spheres of a leaf from place i on, as many as a Row holds. What stands behind the leaf is asked too: it does no
  /// harm.
  Meeting<Row> meet_spheres(const Alone& ray, std::size_t i) const {
    const Spheres<T>& spheres = scene_.spheres;
    const Vec3<Row> c = {load<Row>(&spheres.center.x[i]), load<Row>(&spheres.center.y[i]), load<Row>(&spheres.center.z[i])};
    const Vec3<Row> o = spread<Row>(ray.origin);
    const Passing<Row> passing = pass(o, spread<Row>(ray.direction), c);
    const MaskOf<Row> own =
        lane_numbers<Row>() + IndexOf<Row>(plane_count_ + static_cast<Whole>(i)) == IndexOf<Row>(ray.leaves);
    const MaskOf<Row> asked = (passing.apart <= load<Row>(&spheres.reach[i])) & !own;
    if (none(asked)) return {asked, Row(0), Row(0), asked};
    const Row radius = load<Row>(&spheres.radius[i]);
    return meet(asked, passing, radius, [&]() RAYLAB_ATTRIBUTE { return gap_to_sphere(o, c, radius); });
  }

  /// Does the ray meet one of the spheres from place i on before `t`? Then that becomes the nearest one's distance, and
  /// `place` its place.
  bool nearer_of_spheres(const Alone& ray, std::size_t i, T& t, Whole& place) const {
    const Meeting<Row> meeting = meet_spheres(ray, i);
    if (none(meeting.met)) return false;
    std::array<T, Lanes<Row>::count> distances;
    store(meeting.t, distances.data());
    const T before = t;
    for (std::uint32_t rest = bits(meeting.met); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const T here = distances[static_cast<std::size_t>(lane)];
      const Whole candidate = plane_count_ + static_cast<Whole>(i) + lane;
      if (here < t || (here == t && id_of(candidate) < id_of(place))) {
        t = here;
        place = candidate;
      }
    }
    return t < before;
  }

  /// The point and the normal that the rays of `met` have reached.
  Hit<V> hit_at(const Ray<V>& ray, const Nearest<V>& nearest, const Places<V>& places, Mask met) const {
    Hit<V> hit;
    hit.normal = hit.center = zero();
    hit.radius = V(0);
    hit.place = nearest.place;
    hit.point = ray.origin + nearest.t * ray.direction;
    hit.inside = mask_of<V>(0);
    const Mask spheres = met & (nearest.place >= Index(plane_count_));
    if (any(spheres)) on_sphere(ray, nearest, places, spheres, hit);
    for (std::size_t i = 0; i < scene_.planes.normal.size(); ++i) {
      const Mask here = met & (nearest.place == Index(static_cast<Whole>(i)));
      if (none(here)) continue;
      const Vec3<V> normal = spread<V>(scene_.planes.normal[i]);
      hit.normal = select(here, select(dot(normal, ray.direction) > V(0), -normal, normal), hit.normal);
    }
    return hit;
  }

  /// The vector from the centre is put together from the foot and half the chord, not from the point and the centre: far
  /// away these two are too close to each other.
  void on_sphere(const Ray<V>& ray, const Nearest<V>& nearest, const Places<V>& places, Mask lanes, Hit<V>& hit) const {
    if (places.same()) {
      const std::size_t sphere = places.common() - static_cast<std::size_t>(plane_count_);
      hit.center = center(sphere);
      hit.radius = V(scene_.spheres.radius[sphere]);
    } else {
      const Index sphere = sphere_of(places.each(), lanes);
      hit.center = centers(sphere);
      hit.radius = gather(scene_.spheres.radius.data(), sphere);
    }
    const Passing<V> passing = pass(ray.origin, ray.direction, hit.center);
    const Meeting<V> meeting = meet(lanes, passing, hit.radius,
                                    [&]() RAYLAB_ATTRIBUTE { return gap_to_sphere(ray.origin, hit.center, hit.radius); });
    const Mask own = lanes & ray.inwards & (ray.leaves == nearest.place);
    hit.inside = lanes & (own | meeting.inside);
    const V along = select(own, nearest.t + passing.b, select(meeting.inside, meeting.half, -meeting.half));
    const Vec3<V> outwards = (V(1) / hit.radius) * (passing.perp + along * ray.direction);
    hit.normal = straightened(select(hit.inside, -outwards, outwards));
  }

  // ---- Light --------------------------------------------------------------------------------------------------------

  /// All the light that surfaces send back against `d`, but for their colors.
  V light_on(const Hit<V>& hit, const Vec3<V>& d, const Look<V>& look, Mask lit) {
    V sum(scene_.ambient);
    const Area area = area_of(hit.point, lit);
    for (const PreparedPointLight<T>& light : scene_.point_lights) {
      const Vec3<V> way = spread<V>(light.position) - hit.point;
      const V r = square_root(dot(way, way));
      // One division for both 1/r and 1/(1 + r).
      const V beyond = V(1) + r;
      const V inverse = V(1) / (r * beyond);
      const V fall_off = inverse * r;
      const Seen seen = {(inverse * beyond) * way, r, light.sides};
      const V strength = V(light.intensity) * (fall_off * fall_off);
      sum = sum + light_from(seen, strength, hit, area, d, look, lit & (r > V(0)));
    }
    for (const PreparedDirectionalLight<T>& light : scene_.directional_lights) {
      const Seen seen = {spread<V>(light.l), V(std::numeric_limits<T>::infinity()), light.sides};
      sum = sum + light_from(seen, V(light.intensity), hit, area, d, look, lit);
    }
    return sum;
  }

  /// 0 where the light is not seen; from so far away that distances are infinite, it is not.
  RAYLAB_INLINE V light_from(const Seen& light, V strength, const Hit<V>& hit, const Area& area, const Vec3<V>& d,
                             const Look<V>& look, Mask lit) {
    const V cosine = dot(light.l, hit.normal);
    lit = lit & (cosine > V(0));
    if (scene_.features.lights_in_planes) lit = lit & !in_own_plane(hit, light.sides);
    if (none(lit)) return V(0);
    if (scene_.features.shadows) {
      lit = unblocked(hit, area, light, lit);
      if (none(lit)) return V(0);
    }
    const V shown = scene_.features.highlights ? cosine + shine(light, hit, d, look, lit) : cosine;
    return select(lit, shown * strength, V(0));
  }

  V shine(const Seen& light, const Hit<V>& hit, const Vec3<V>& d, const Look<V>& look, Mask lit) const {
    const V k_s = look.strength;
    return k_s * highlight(lit & (k_s > V(0)), light.l, hit.normal, -d, look.alpha);
  }

  /// Is the light in the very plane that it would light? The rounded cosine is not 0 then, and may be above it.
  Mask in_own_plane(const Hit<V>& hit, const Sides& sides) const {
    Mask in = mask_of<V>(0);
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i] == 0) in = in | (hit.place == Index(static_cast<Whole>(i)));
    return in;
  }

  /// Those of `asked` that nothing opaque hides from the light.
  RAYLAB_INLINE Mask unblocked(const Hit<V>& hit, const Area& area, const Seen& light, Mask asked) {
    add(asked, counts_.shadow);
    Mask open = not_behind_planes(hit, light.sides, asked);
    const SphereGroup& opaque = scene_.spheres.opaque;
    const Mask inside = open & hit.inside & (hit.place < place_of(scene_.spheres.glass.begin));
    if (any(inside)) open = open & !(inside & far_side_blocks(hit, light, inside));
    const Beam beam = beam_of(area, light);
    for_each_reached(beam, opaque.begin, opaque.loop_end, [&](std::size_t i) RAYLAB_ATTRIBUTE {
      open = open & !blocked_by(hit, light, open, i);
      return any(open);
    });
    if (opaque.hierarchy && any(open)) open = search_unblocked(hit, light, beam, open);
    return open;
  }

  Mask not_behind_planes(const Hit<V>& hit, const Sides& sides, Mask asked) const {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (sides[i] == 0) continue;
      const V side = dot(spread<V>(scene_.planes.point[i]) - hit.point, spread<V>(scene_.planes.normal[i]));
      const Mask behind = (sides[i] > 0 ? side <= V(0) : side >= V(0)) & !(hit.place == Index(static_cast<Whole>(i)));
      asked = asked & !behind;
    }
    return asked;
  }

  Mask far_side_blocks(const Hit<V>& hit, const Seen& light, Mask lanes) const {
    return far_side(pass(hit.point, light.l, centers(sphere_of(hit.place, lanes)))) < light.distance;
  }

  RAYLAB_INLINE Mask blocked_by(const Hit<V>& hit, const Seen& light, Mask open, std::size_t i) const {
    const Passing<V> passing = pass(hit.point, light.l, center(i));
    const Mask asked = may_meet(hit.place, open, i, passing, light.distance);
    if (none(asked)) return asked;
    const Meeting<V> meeting = meet_one(hit.point, asked, passing, i);
    return meeting.met & (meeting.t < light.distance);
  }

  Mask search_unblocked(const Hit<V>& hit, const Seen& light, const Beam& beam, Mask open) const {
    const float longest = as_limit(greatest_lane(select(open, light.distance, V(-1))));
    const auto limit = [&]() RAYLAB_ATTRIBUTE { return any(open) ? longest : -1.0f; };
    const auto visit = [&](std::size_t i) RAYLAB_ATTRIBUTE {
      open = open & !blocked_by(hit, light, open, i);
      return any(open);
    };
    if (search_beam(scene_.spheres.opaque, beam, open, limit, visit) || none(open)) return open;
    return search_unblocked_each({hit.point, light.l, hit.place, hit.inside}, light.distance, open);
  }

  Mask search_unblocked_each(const Ray<V>& shadow, V distance, Mask open) const {
    const SphereGroup& group = scene_.spheres.opaque;
    const Singles rays(shadow);
    std::array<T, Lanes<V>::count> distances;
    store(distance, distances.data());
    Limits<Lanes<V>::count> limits = limits_of(bits(open), distances);
    std::uint32_t blocked = 0;
    search_each(*group.hierarchy, rays.probes(*group.hierarchy), bits(open), limits,
                [&](std::size_t begin, std::size_t count, std::size_t lane) RAYLAB_ATTRIBUTE {
                  for (std::size_t i = group.loop_end + begin; i < group.loop_end + begin + count; i += Lanes<Row>::count) {
                    const Meeting<Row> meeting = meet_spheres(rays.ray(lane), i);
                    if (none(meeting.met & (meeting.t < Row(distances[lane])))) continue;
                    blocked |= 1u << lane;
                    limits[lane] = -1;
                    return;
                  }
                });
    return open & !mask_of<V>(blocked);
  }

  /// Light beyond the largest number is infinite, but black stays black.
  static Vec3<V> tinted(V light, const Vec3<V>& color) {
    const auto part = [light](V c) RAYLAB_ATTRIBUTE { return select(c > V(0), light * c, V(0)); };
    return {part(color.x), part(color.y), part(color.z)};
  }

  // ---- Bounces ------------------------------------------------------------------------------------------------------

  void send_on(const Waiting& from, const Hit<V>& hit, const Look<V>& look, Mask met, Mask glass) {
    if (from.bounce >= scene_.settings.max_bounces) return;
    if (any(glass))
      send_from_glass(from, hit, look, met, glass);
    else if (scene_.features.mirrors)
      send_reflected(from, hit, look.mirror, met);
  }

  void send_reflected(const Waiting& from, const Hit<V>& hit, V weight, Mask lanes) {
    const Vec3<V>& d = from.ray.direction;
    const Vec3<V> away = straightened(d - (V(2) * dot(d, hit.normal)) * hit.normal);
    send(from, {hit.point, away, hit.place, hit.inside}, weight, lanes, counts_.reflected);
  }

  /// From glass in the lanes of `glass`, which sends on two rays, and from mirrors in the others.
  void send_from_glass(const Waiting& from, const Hit<V>& hit, const Look<V>& look, Mask met, Mask glass) {
    const Vec3<V>& d = from.ray.direction;
    const T* const finishes = scene_.finishes.numbers.data();
    const Glass<V> what = {gather(finishes + ior, look.finish_row), gather(finishes + ior_squared_minus_1, look.finish_row),
                           gather(finishes + r0, look.finish_row)};
    const Refraction<V> refraction = refract(d, hit.normal, hit.inside, what);
    const Parts<V> parts = schlick(refraction, hit.inside, what);
    send_reflected(from, hit, select(glass, parts.reflected, look.mirror), met);
    const Mask through = glass & (parts.refracted > V(0));
    Refracted<V> ahead = through_sphere(refraction, d, hit.normal, hit.center, hit.radius, what);
    if (any(through & hit.inside)) {
      const Refracted<V> out = out_of_sphere(refraction, d, hit.normal, hit.point, what);
      ahead = {select(hit.inside, out.origin, ahead.origin), select(hit.inside, out.direction, ahead.direction)};
    }
    send(from, {ahead.origin, ahead.direction, hit.place, mask_of<V>(0)}, parts.refracted, through, counts_.refracted);
  }

  void send(const Waiting& from, const Ray<V>& ray, V weight, Mask lanes, std::uint64_t& counter) {
    const V reaches_pixel = from.weight * weight;
    lanes = lanes & (reaches_pixel > V(0));
    if (none(lanes)) return;
    add(lanes, counter);
    wait(ray, reaches_pixel, lanes, from.bounce + 1);
  }

  /// Part by part: compilers copy a large thing byte by byte.
  RAYLAB_INLINE void wait(const Ray<V>& ray, V weight, Mask lanes, int bounce) {
    Waiting& rays = waiting_.push();
    rays.ray.origin = ray.origin;
    rays.ray.direction = ray.direction;
    rays.ray.leaves = ray.leaves;
    rays.ray.inwards = ray.inwards;
    rays.weight = weight;
    rays.lanes = lanes;
    rays.bounce = bounce;
  }

  static void add(Mask lanes, std::uint64_t& counter) { counter += count(lanes); }

  const Prepared<T>& scene_;
  const Whole plane_count_;
  V tile_x_, tile_y_;  // of each lane, in its tile
  Mask all_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  WaitingRays<Waiting> waiting_;
};

/// A kernel's entry: see TraceRows.
template <class V>
void trace_rows(const Prepared<NumberOf<V>>& scene, int first_row, std::span<Color> pixels, RayCounts& counts,
                const std::atomic<bool>& cancel) {
  Tracer<V>(scene, counts, cancel).rows(first_row, pixels);
}

}  // namespace raylab::fast::RAYLAB_TARGET
