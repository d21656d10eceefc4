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
  Vec3<V> normal;     ///< unit, turned to the ray's side
  IndexOf<V> place;
  MaskOf<V> inside;   ///< met from the inside of a sphere
  Vec3<V> center;     ///< of the sphere
  V radius;
};

/// Rows of a table, one for each lane; where all lanes look at the same row no gather is needed.
template <class V>
class Rows {
 public:
  using T = NumberOf<V>;

  template <int width>
  Rows(const Table<T, width>& table, IndexOf<V> rows, MaskOf<V> lanes) : table_(table.numbers.data()) {
    const auto first = static_cast<std::size_t>(std::countr_zero(bits(lanes)));
    std::array<WholeOf<V>, Lanes<V>::count> places;
    store(rows, places.data());
    const WholeOf<V> row = places[first];
    if (none(lanes & !(rows == IndexOf<V>(row))))
      common_ = table_ + row * width;
    else
      starts_ = select(lanes, shifted_left<std::countr_zero(static_cast<unsigned>(width))>(rows), IndexOf<V>(0));
  }

  V operator[](int column) const { return common_ != nullptr ? V(common_[column]) : gather(table_ + column, starts_); }

 private:
  const T* table_;
  const T* common_ = nullptr;
  IndexOf<V> starts_ = IndexOf<V>(0);
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
      : scene_(scene), plane_count_(static_cast<Whole>(scene.planes.point.size())), counts_(counts), cancel_(cancel) {}

  /// Whole rows, as Engine::trace_rows says.
  void rows(int first_row, std::span<Color> pixels) {
    const int width = scene_.settings.size.width;
    const int height = static_cast<int>(pixels.size() / static_cast<std::size_t>(width));
    for (int row = 0; row < height; row += Tile::height)
      for (int column = 0; column < width; column += Tile::width) tile(column, row, first_row, width, height, pixels);
  }

 private:
  using Whole = WholeOf<V>;

  /// The pixels that are traced together: a block, whose rays stay together longer than those of a row.
  struct Tile {
    static constexpr int width = Lanes<V>::count >= 8 ? 4 : Lanes<V>::count >= 2 ? 2 : 1;
    static constexpr int height = Lanes<V>::count / width;
  };

  /// A ray to be traced in each lane of `lanes`, and how much of its color reaches the pixel.
  struct Waiting {
    Ray<V> ray;
    V weight;
    Mask lanes;
    int bounce;
  };

  void tile(int column, int row, int first_row, int width, int height, std::span<Color> pixels) {
    const int columns = std::min(Tile::width, width - column), rows = std::min(Tile::height, height - row);
    std::array<T, Lanes<V>::count> x, y;
    std::uint32_t inside = 0;
    for (int lane = 0; lane < Lanes<V>::count; ++lane) {
      const int i = lane % Tile::width, j = lane / Tile::width;
      x[static_cast<std::size_t>(lane)] = static_cast<T>(column + i) + T(0.5) - T(0.5) * static_cast<T>(scene_.settings.size.width);
      y[static_cast<std::size_t>(lane)] = T(0.5) * static_cast<T>(scene_.settings.size.height) - static_cast<T>(first_row + row + j) - T(0.5);
      if (i < columns && j < rows) inside |= 1u << lane;
    }
    const Vec3<V> color = pixel(load<V>(x.data()), load<V>(y.data()), mask_of<V>(inside));
    std::array<std::array<T, Lanes<V>::count>, 3> parts;
    store(clamped(color.x), parts[0].data());
    store(clamped(color.y), parts[1].data());
    store(clamped(color.z), parts[2].data());
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const auto lane = static_cast<std::size_t>(j * Tile::width + i);
        pixels[static_cast<std::size_t>(row + j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column + i)] = {
            parts[0][lane], parts[1][lane], parts[2][lane]};
      }
  }

  static Vec3<V> zero() { return {V(0), V(0), V(0)}; }

  /// A NaN stays one: the program counts and reports it.
  static V clamped(V c) { return select(c < V(0), V(0), select(c > V(1), V(1), c)); }

  /// The mean of the samples of the pixels whose centres are at (x, y), not yet clamped.
  Vec3<V> pixel(V x, V y, Mask lanes) {
    Vec3<V> sum = zero();
    for (const SampleOffset& sample : scene_.samples)
      sum = sum + primary(x + V(static_cast<T>(sample.dx)), y + V(static_cast<T>(sample.dy)), lanes);
    return V(T(1) / static_cast<T>(scene_.samples.size())) * sum;
  }

  Vec3<V> primary(V x, V y, Mask lanes) {
    count(lanes, counts_.primary);
    const PreparedCamera<T>& camera = scene_.camera;
    const Vec3<V> towards = spread<V>(camera.forward) + x * spread<V>(camera.right) + y * spread<V>(camera.up);
    const Vec3<V> d = (V(1) / square_root(dot(towards, towards))) * towards;
    if (scene_.settings.stage == 1) return V(T(0.5)) * (d + Vec3<V>{V(1), V(1), V(1)});
    return color({{spread<V>(camera.position), d, Index(-1), mask_of<V>(0)}, V(1), lanes, 0});
  }

  /// The color at the end of primary rays. Glass splits a ray in two: those to come wait on a stack, which never holds more
  /// than one for each bounce.
  Vec3<V> color(const Waiting& primary_rays) {
    Vec3<V> sum = zero();
    waiting_[waiting_count_++] = primary_rays;
    while (waiting_count_ > 0) {
      const Waiting next = waiting_[--waiting_count_];
      sum = select(next.lanes, sum + next.weight * surface_color(next), sum);
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
    const Rows<V> surface(scene_.surfaces, nearest.place, met);
    const Vec3<V> own = {surface[red], surface[green], surface[blue]};
    if (scene_.settings.stage == 2) return select(met, own, background);
    const Rows<V> look(scene_.finishes, whole(surface[finish]), met);
    const Hit<V> hit = hit_at(from.ray, nearest, met);
    const Mask glass = scene_.features.glass ? met & (look[is_glass] > V(0)) : mask_of<V>(0);
    const Mask lit = met & !glass;
    send_on(from, hit, look, met, glass);
    const Vec3<V> seen = any(lit) ? tinted(light_on(hit, from.ray.direction, look, lit), own) : zero();
    return select(lit, seen, select(glass, zero(), background));
  }

  // ---- Intersections ------------------------------------------------------------------------------------------------

  Nearest<V> nearest_surface(const Ray<V>& ray, Mask lanes) {
    Nearest<V> best = {V(std::numeric_limits<T>::infinity()), Index(-1)};
    for (std::size_t i = 0; i < scene_.planes.point.size(); ++i) {
      const V t = plane_distance(ray.origin, ray.direction, spread<V>(scene_.planes.point[i]), spread<V>(scene_.planes.normal[i]));
      const Index place(static_cast<Whole>(i));
      const Mask closer = lanes & (t >= V(0)) & (t < best.t) & !(ray.leaves == place);
      best.t = select(closer, t, best.t);
      best.place = select(closer, place, best.place);
    }
    if (any(ray.inwards)) meet_own_sphere(ray, lanes & ray.inwards, best);
    for (const SphereGroup* group : {&scene_.spheres.opaque, &scene_.spheres.glass}) {
      for (std::size_t i = group->begin; i < group->loop_end; ++i) meet_sphere(ray, lanes, i, best);
      if (group->hierarchy) search_nearest(ray, lanes, *group, best);
    }
    return best;
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

  /// Lanes whose line passes sphere i closely enough, but for those that leave it, that have it behind them, or that have met
  /// something nearer for certain.
  Mask may_meet(const Ray<V>& ray, Mask lanes, std::size_t i, const Passing<V>& passing, V limit) const {
    const V reach(scene_.spheres.reach[i]);
    const Mask close = lanes & (passing.apart <= reach);
    if (none(close)) return close;
    const V radius(scene_.spheres.radius[i] * (1 + 256 * std::numeric_limits<T>::epsilon()));
    const Mask ahead = (passing.b < V(0)) | (passing.b * passing.b + passing.apart <= reach);
    return close & ahead & (-passing.b - radius <= limit) & !(ray.leaves == place_of(i));
  }

  Index place_of(std::size_t sphere) const { return Index(plane_count_ + static_cast<Whole>(sphere)); }

  RAYLAB_INLINE void meet_sphere(const Ray<V>& ray, Mask lanes, std::size_t i, Nearest<V>& best) const {
    const Vec3<V> c = center(i);
    const Passing<V> passing = pass(ray.origin, ray.direction, c);
    const Mask asked = may_meet(ray, lanes, i, passing, best.t);
    if (none(asked)) return;
    const Meeting<V> meeting = meet(asked, passing, ray.origin, c, V(scene_.spheres.radius[i]));
    update(meeting.met, meeting.t, place_of(i), best);
  }

  /// The nearer one wins; of equal t the one that stands first in the scene (D7).
  void update(Mask met, V t, Index place, Nearest<V>& best) const {
    Mask closer = met & (t < best.t);
    const Mask tied = met & (t == best.t);
    if (any(tied)) [[unlikely]] closer = closer | (tied & stands_before(tied, place, best.place));
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
    return place < plane_count_ ? static_cast<GeometryId>(place) : scene_.spheres.id[static_cast<std::size_t>(place - plane_count_)];
  }

  // ---- Many spheres -------------------------------------------------------------------------------------------------

  void search_nearest(const Ray<V>& ray, Mask lanes, const SphereGroup& group, Nearest<V>& best) {
    const Bundle bundle(ray, lanes);
    if (bundle.coherent()) {
      const auto limit = [&] { return as_limit(greatest_lane(select(lanes, best.t, V(-1)))); };
      search(*group.hierarchy, Probe(*group.hierarchy, bundle.bounds()), limit(), [&](std::size_t begin, std::size_t count) {
        for (std::size_t i = group.loop_end + begin; i < group.loop_end + begin + count; ++i) meet_sphere(ray, lanes, i, best);
        return limit();
      });
      return;
    }
    Single single(ray);
    std::array<T, Lanes<V>::count> t;
    std::array<Whole, Lanes<V>::count> places;
    store(best.t, t.data());
    store(best.place, places.data());
    for (std::uint32_t rest = bits(lanes); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      search_nearest_alone(single.ray(lane), group, t[lane], places[lane]);
    }
    best.t = load<V>(t.data());
    best.place = load_index<V>(places.data());
  }

  /// One lane's ray.
  struct Alone {
    Point<T> origin, direction;
    Whole leaves;

    typename Probe::Bounds bounds() const {
      const std::array<double, 3> o = {origin.x, origin.y, origin.z}, d = {direction.x, direction.y, direction.z};
      return {o, o, d, d};
    }
  };

  /// Takes rays out of their lanes.
  class Single {
   public:
    explicit Single(const Ray<V>& ray) {
      store(ray.origin.x, numbers_[0].data());
      store(ray.origin.y, numbers_[1].data());
      store(ray.origin.z, numbers_[2].data());
      store(ray.direction.x, numbers_[3].data());
      store(ray.direction.y, numbers_[4].data());
      store(ray.direction.z, numbers_[5].data());
      store(ray.leaves, leaves_.data());
    }

    Alone ray(std::size_t lane) const {
      return {{numbers_[0][lane], numbers_[1][lane], numbers_[2][lane]},
              {numbers_[3][lane], numbers_[4][lane], numbers_[5][lane]},
              leaves_[lane]};
    }

   private:
    std::array<std::array<T, Lanes<V>::count>, 6> numbers_;
    std::array<Whole, Lanes<V>::count> leaves_;
  };

  /// As many of a leaf's spheres as there are lanes, from place i on. What stands behind the leaf is asked too: it does no harm.
  Meeting<V> meet_spheres(const Alone& ray, std::size_t i) const {
    const Spheres<T>& spheres = scene_.spheres;
    const Vec3<V> c = {load<V>(&spheres.center.x[i]), load<V>(&spheres.center.y[i]), load<V>(&spheres.center.z[i])};
    const Vec3<V> o = spread<V>(ray.origin);
    const Passing<V> passing = pass(o, spread<V>(ray.direction), c);
    const Mask close = passing.apart <= load<V>(&spheres.reach[i]);
    if (none(close)) return {close, V(0), V(0), close};
    const Mask asked = close & !(lane_numbers<V>() + place_of(i) == Index(ray.leaves));
    return meet(asked, passing, o, c, load<V>(&spheres.radius[i]));
  }

  void search_nearest_alone(const Alone& ray, const SphereGroup& group, T& t, Whole& place) const {
    search(*group.hierarchy, Probe(*group.hierarchy, ray.bounds()), as_limit(t), [&](std::size_t begin, std::size_t count) {
      for (std::size_t i = group.loop_end + begin; i < group.loop_end + begin + count; i += Lanes<V>::count) {
        const Meeting<V> meeting = meet_spheres(ray, i);
        if (none(meeting.met)) continue;
        std::array<T, Lanes<V>::count> distances;
        store(meeting.t, distances.data());
        for (std::uint32_t rest = bits(meeting.met); rest != 0; rest &= rest - 1) {
          const int lane = std::countr_zero(rest);
          const T here = distances[static_cast<std::size_t>(lane)];
          const Whole candidate = plane_count_ + static_cast<Whole>(i) + lane;
          if (here < t || (here == t && id_of(candidate) < id_of(place))) {
            t = here;
            place = candidate;
          }
        }
      }
      return as_limit(t);
    });
  }

  /// Rays that are searched together: the bounds of all that a mask selects.
  class Bundle {
   public:
    Bundle(const Ray<V>& ray, Mask lanes) : rays_(std::popcount(bits(lanes))) {
      if (rays_ < least_rays) return;
      const auto bound = [&](std::size_t axis, V origin, V direction) {
        const V all(std::numeric_limits<T>::infinity());
        bounds_.low_origin[axis] = least_lane(select(lanes, origin, all));
        bounds_.high_origin[axis] = greatest_lane(select(lanes, origin, -all));
        bounds_.low_direction[axis] = least_lane(select(lanes, direction, all));
        bounds_.high_direction[axis] = greatest_lane(select(lanes, direction, -all));
        spread_ = std::max(spread_, bounds_.high_direction[axis] - bounds_.low_direction[axis]);
      };
      bound(0, ray.origin.x, ray.direction.x);
      bound(1, ray.origin.y, ray.direction.y);
      bound(2, ray.origin.z, ray.direction.z);
    }

    bool coherent() const { return rays_ >= least_rays && spread_ < largest_spread; }
    const Probe::Bounds& bounds() const { return bounds_; }

   private:
    static constexpr int least_rays = 3;
    static constexpr double largest_spread = 0.25;

    int rays_;
    double spread_ = 0;
    Probe::Bounds bounds_{};
  };

  /// The point and the normal that the rays of `met` have reached.
  Hit<V> hit_at(const Ray<V>& ray, const Nearest<V>& nearest, Mask met) const {
    Hit<V> hit;
    hit.normal = hit.center = zero();
    hit.radius = V(0);
    hit.place = nearest.place;
    hit.point = ray.origin + nearest.t * ray.direction;
    hit.inside = mask_of<V>(0);
    const Mask spheres = met & (nearest.place >= Index(plane_count_));
    if (any(spheres)) on_sphere(ray, nearest, spheres, hit);
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
  void on_sphere(const Ray<V>& ray, const Nearest<V>& nearest, Mask lanes, Hit<V>& hit) const {
    const Index sphere = sphere_of(nearest.place, lanes);
    hit.center = centers(sphere);
    hit.radius = gather(scene_.spheres.radius.data(), sphere);
    const Passing<V> passing = pass(ray.origin, ray.direction, hit.center);
    const Meeting<V> meeting = meet(lanes, passing, ray.origin, hit.center, hit.radius);
    const Mask own = lanes & ray.inwards & (ray.leaves == nearest.place);
    hit.inside = lanes & (own | meeting.inside);
    const V along = select(own, nearest.t + passing.b, select(meeting.inside, meeting.half, -meeting.half));
    const Vec3<V> outwards = (V(1) / hit.radius) * (passing.perp + along * ray.direction);
    hit.normal = straightened(select(hit.inside, -outwards, outwards));
  }

  // ---- Light --------------------------------------------------------------------------------------------------------

  /// A light as points see it.
  struct Seen {
    Vec3<V> l;  ///< unit, towards the light
    V distance;
    const Sides& sides;
  };

  /// All the light that surfaces send back against `d`, but for their colors.
  V light_on(const Hit<V>& hit, const Vec3<V>& d, const Rows<V>& look, Mask lit) {
    V sum(scene_.ambient);
    for (const PreparedPointLight<T>& light : scene_.point_lights) {
      const Vec3<V> way = spread<V>(light.position) - hit.point;
      const V r = square_root(dot(way, way));
      // One division for both 1/r and 1/(1 + r).
      const V beyond = V(1) + r;
      const V inverse = V(1) / (r * beyond);
      const V fall_off = inverse * r;
      const Seen seen = {(inverse * beyond) * way, r, light.sides};
      sum = sum + light_from(seen, hit, d, look, lit & (r > V(0))) * (V(light.intensity) * (fall_off * fall_off));
    }
    for (const PreparedDirectionalLight<T>& light : scene_.directional_lights) {
      const Seen seen = {spread<V>(light.l), V(std::numeric_limits<T>::infinity()), light.sides};
      sum = sum + light_from(seen, hit, d, look, lit) * V(light.intensity);
    }
    return sum;
  }

  /// Before the light's strength; 0 where the light is not seen.
  V light_from(const Seen& light, const Hit<V>& hit, const Vec3<V>& d, const Rows<V>& look, Mask lit) {
    const V cosine = dot(light.l, hit.normal);
    lit = lit & (cosine > V(0));
    if (scene_.features.lights_in_planes) lit = lit & !in_own_plane(hit, light.sides);
    if (none(lit)) return V(0);
    if (scene_.features.shadows) {
      lit = unblocked(hit, light, lit);
      if (none(lit)) return V(0);
    }
    return select(lit, scene_.features.highlights ? cosine + shine(light, hit, d, look, lit) : cosine, V(0));
  }

  V shine(const Seen& light, const Hit<V>& hit, const Vec3<V>& d, const Rows<V>& look, Mask lit) const {
    const V k_s = look[strength];
    return k_s * highlight(lit & (k_s > V(0)), light.l, hit.normal, -d, look[alpha]);
  }

  /// Is the light in the very plane that it would light? The rounded cosine is not 0 then, and may be above it.
  Mask in_own_plane(const Hit<V>& hit, const Sides& sides) const {
    Mask in = mask_of<V>(0);
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i] == 0) in = in | (hit.place == Index(static_cast<Whole>(i)));
    return in;
  }

  /// Those of `asked` that nothing opaque hides from the light.
  Mask unblocked(const Hit<V>& hit, const Seen& light, Mask asked) {
    count(asked, counts_.shadow);
    Mask open = not_behind_planes(hit, light.sides, asked);
    const Ray<V> shadow = {hit.point, light.l, hit.place, hit.inside};
    const SphereGroup& opaque = scene_.spheres.opaque;
    const Mask inside = open & hit.inside & (hit.place < place_of(scene_.spheres.glass.begin));
    if (any(inside)) open = open & !(inside & far_side_blocks(shadow, light.distance, inside));
    for (std::size_t i = opaque.begin; i < opaque.loop_end; ++i) {
      if (none(open)) return open;
      open = open & !blocked_by(shadow, light.distance, open, i);
    }
    if (opaque.hierarchy && any(open)) open = search_unblocked(shadow, light.distance, open);
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

  Mask far_side_blocks(const Ray<V>& shadow, V distance, Mask lanes) const {
    return far_side(pass(shadow.origin, shadow.direction, centers(sphere_of(shadow.leaves, lanes)))) < distance;
  }

  RAYLAB_INLINE Mask blocked_by(const Ray<V>& shadow, V distance, Mask open, std::size_t i) const {
    const Vec3<V> c = center(i);
    const Passing<V> passing = pass(shadow.origin, shadow.direction, c);
    const Mask asked = may_meet(shadow, open, i, passing, distance);
    if (none(asked)) return asked;
    const Meeting<V> meeting = meet(asked, passing, shadow.origin, c, V(scene_.spheres.radius[i]));
    return meeting.met & (meeting.t < distance);
  }

  Mask search_unblocked(const Ray<V>& shadow, V distance, Mask open) const {
    const SphereGroup& group = scene_.spheres.opaque;
    const Bundle bundle(shadow, open);
    if (bundle.coherent()) {
      const float limit = as_limit(greatest_lane(select(open, distance, V(-1))));
      search(*group.hierarchy, Probe(*group.hierarchy, bundle.bounds()), limit, [&](std::size_t begin, std::size_t count) {
        for (std::size_t i = group.loop_end + begin; i < group.loop_end + begin + count; ++i)
          open = open & !blocked_by(shadow, distance, open, i);
        return any(open) ? limit : -1.0f;
      });
      return open;
    }
    Single single(shadow);
    std::array<T, Lanes<V>::count> distances;
    store(distance, distances.data());
    std::uint32_t unblocked = 0;
    for (std::uint32_t rest = bits(open); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      if (!blocked_alone(single.ray(lane), distances[lane], group)) unblocked |= 1u << lane;
    }
    return mask_of<V>(unblocked);
  }

  bool blocked_alone(const Alone& ray, T distance, const SphereGroup& group) const {
    bool blocked = false;
    const float limit = as_limit(distance);
    search(*group.hierarchy, Probe(*group.hierarchy, ray.bounds()), limit, [&](std::size_t begin, std::size_t count) {
      for (std::size_t i = group.loop_end + begin; i < group.loop_end + begin + count && !blocked; i += Lanes<V>::count) {
        const Meeting<V> meeting = meet_spheres(ray, i);
        blocked = any(meeting.met & (meeting.t < V(distance)));
      }
      return blocked ? -1.0f : limit;
    });
    return blocked;
  }

  /// Light beyond the largest number is infinite, but black stays black.
  static Vec3<V> tinted(V light, const Vec3<V>& color) {
    const auto part = [light](V c) RAYLAB_ATTRIBUTE { return select(c > V(0), light * c, V(0)); };
    return {part(color.x), part(color.y), part(color.z)};
  }

  // ---- Bounces ------------------------------------------------------------------------------------------------------

  void send_on(const Waiting& from, const Hit<V>& hit, const Rows<V>& look, Mask met, Mask glass) {
    if (from.bounce >= scene_.settings.max_bounces) return;
    if (any(glass))
      send_from_glass(from, hit, look, met, glass);
    else if (scene_.features.mirrors)
      send_reflected(from, hit, look[mirror], met);
  }

  void send_reflected(const Waiting& from, const Hit<V>& hit, V weight, Mask lanes) {
    const Vec3<V>& d = from.ray.direction;
    const Vec3<V> away = straightened(d - (V(2) * dot(d, hit.normal)) * hit.normal);
    send(from, {hit.point, away, hit.place, hit.inside}, weight, lanes, counts_.reflected);
  }

  /// From glass in the lanes of `glass`, which sends on two rays, and from mirrors in the others.
  void send_from_glass(const Waiting& from, const Hit<V>& hit, const Rows<V>& look, Mask met, Mask glass) {
    const Vec3<V>& d = from.ray.direction;
    const Glass<V> what = {look[ior], look[ior_squared_minus_1], look[r0]};
    const Refraction<V> refraction = refract(d, hit.normal, hit.inside, what);
    const Parts<V> parts = schlick(refraction, hit.inside, what);
    send_reflected(from, hit, select(glass, parts.reflected, look[mirror]), met);
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
    count(lanes, counter);
    waiting_[waiting_count_++] = {ray, reaches_pixel, lanes, from.bounce + 1};
  }

  static void count(Mask lanes, std::uint64_t& counter) { counter += static_cast<std::uint64_t>(std::popcount(bits(lanes))); }

  const Prepared<T>& scene_;
  const Whole plane_count_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  std::array<Waiting, most_bounces + 2> waiting_;
  std::size_t waiting_count_ = 0;
};

/// A kernel's entry: see TraceRows.
template <class V>
void trace_rows(const Prepared<NumberOf<V>>& scene, int first_row, std::span<Color> pixels, RayCounts& counts,
                const std::atomic<bool>& cancel) {
  Tracer<V>(scene, counts, cancel).rows(first_row, pixels);
}

}  // namespace raylab::fast::RAYLAB_TARGET
