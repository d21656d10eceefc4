// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Finds the nearest surfaces that rays meet, and where, in scenes with planes or without.
template <class V, bool planes>
class NearestSearch {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;
  using Whole = WholeOf<V>;

  explicit NearestSearch(const Prepared<T>& scene)
      : scene_(scene), spheres_(scene), first_plane_(scene.first_plane()), tile_growth_(growth_of_tile<V>(scene.camera)) {}

  /// `primary`: the rays are the camera's through one tile, there is one in the first lane, and none leaves a surface.
  template <bool primary>
  RAYLAB_INLINE Nearest<V> nearest_surface(const Ray<V>& ray, Mask lanes) const {
    Nearest<V> best = {V(std::numeric_limits<T>::infinity()), Index(-1)};
    if constexpr (planes) meet_planes(ray, lanes, best);
    if (!primary && any(ray.inwards)) meet_own_sphere(ray, lanes & ray.inwards, best);
    if (scene_.spheres.count > 0) nearest_sphere<primary>(ray, lanes, best);
    return best;
  }

  /// The spheres of `lanes` that rays have met.
  Ball<V> balls_at(const Places<V>& places, Mask lanes) const { return spheres_.balls_at(places, lanes); }

  /// The point and the normal that the rays of `met` have reached.
  RAYLAB_INLINE Hit<V> hit_at(const Ray<V>& ray, const Nearest<V>& nearest, const Places<V>& places, Mask met) const {
    Hit<V> hit;
    hit.place = nearest.place;
    hit.point = ray.origin + nearest.t * ray.direction;
    if constexpr (!planes)
      on_sphere(ray, nearest, places, met, hit);
    else if (!places.same())
      on_surfaces(ray, nearest, places, met, hit);
    else if (const auto place = static_cast<std::size_t>(places.common()); place >= first_plane_)
      on_plane(ray, place - first_plane_, hit);
    else
      on_sphere(ray, nearest, places, met, hit);
    return hit;
  }

 private:
  using Row = typename SphereSearch<V>::Row;
  using SphereRow = typename SphereSearch<V>::SphereRow;

  /// To ask so many is faster than to find out which ones a beam reaches.
  static constexpr std::size_t few_spheres = 8;

  RAYLAB_INLINE void meet_planes(const Ray<V>& ray, Mask lanes, Nearest<V>& best) const {
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
      const PreparedPlane<T>& plane = scene_.planes[i];
      const V t = plane_distance(ray.origin, ray.direction, spread<V>(plane.point), spread<V>(plane.normal));
      const Index place = spheres_.all_at(first_plane_ + i);
      replace(without(lanes & (t >= V(0)) & (t < best.t), ray.leaves == place), t, place, best);
    }
  }

  template <bool primary>
  RAYLAB_INLINE void nearest_sphere(const Ray<V>& ray, Mask lanes, Nearest<V>& best) const {
    const std::size_t count = scene_.spheres.count;
    if (count > few_spheres) {
      nearest_of_many(ray, lanes, best);
    } else if constexpr (primary) {
      const Point<T> direction = lane(ray.direction, 0);
      const Beam<T> beam = {scene_.camera.position, direction, 0, tile_growth_, std::numeric_limits<T>::infinity()};
      // Inlined, whatever else the compiler has to inline.
      spheres_.for_each_reached(
          beam, 0, count, [&](std::size_t i) RAYLAB_ATTRIBUTE __attribute__((always_inline)) {
            meet_sphere(ray, lanes, i, best);
            return true;
          });
    } else {
      for (std::size_t i = 0; i < count; ++i) meet_sphere(ray, lanes, i, best);
    }
  }

  /// Apart, so that few spheres need not keep registers for many.
  [[gnu::noinline]] void nearest_of_many(const Ray<V>& ray, Mask lanes, Nearest<V>& best) const {
    const Beam<T> beam = beam_of(ray, lanes, best.t);
    for (const SphereGroup* group : {&scene_.spheres.opaque, &scene_.spheres.glass}) {
      if (group->begin < group->loop_end) nearest_of_each(ray, lanes, beam, *group, best);
      if (group->hierarchy) search_nearest(ray, lanes, beam, *group, best);
    }
  }

  [[gnu::noinline]] void nearest_of_each(const Ray<V>& ray, Mask lanes, const Beam<T>& beam, const SphereGroup& group,
                                         Nearest<V>& best) const {
    spheres_.for_each_reached(beam, group.begin, group.loop_end, [&](std::size_t i) RAYLAB_ATTRIBUTE {
      meet_sphere(ray, lanes, i, best);
      return true;
    });
  }

  void meet_own_sphere(const Ray<V>& ray, Mask lanes, Nearest<V>& best) const {
    const V t = far_side(pass(ray.origin, ray.direction, spheres_.centers(spheres_.spheres_at(ray.leaves, lanes))));
    update(lanes, t, ray.leaves, best);
  }

  RAYLAB_INLINE void meet_sphere(const Ray<V>& ray, Mask lanes, std::size_t i, Nearest<V>& best) const {
    const Passing<V> passing = pass(ray.origin, ray.direction, spheres_.center(i));
    const Mask close = spheres_.passing_close(lanes, i, passing);
    if (none(close)) return;
    const Mask asked = without(close, ray.leaves == spheres_.all_at(i));
    const V radius = spheres_.radius(i);
    if (any(starts_within(asked, passing, radius))) [[unlikely]]
      return meet_sphere_from_within(ray, asked, i, best);
    const Meeting<V> meeting = meet_from_afar(asked, passing, radius);
    update(meeting.met, meeting.t, spheres_.all_at(i), best);
  }

  [[gnu::noinline]] void meet_sphere_from_within(const Ray<V>& ray, Mask asked, std::size_t i, Nearest<V>& best) const {
    const Meeting<V> meeting = meet(asked, ray.origin, ray.direction, spheres_.center(i), spheres_.radius(i));
    update(meeting.met, meeting.t, spheres_.all_at(i), best);
  }

  /// The nearer one wins; of equal t the one that stands first in the scene (D7).
  RAYLAB_INLINE void update(Mask met, V t, Index place, Nearest<V>& best) const {
    const Mask tied = met & (t == best.t);
    if (any(tied)) [[unlikely]]
      return update_tied(met, tied, t, place, best);
    replace(met & (t < best.t), t, place, best);
  }

  RAYLAB_INLINE void replace(Mask closer, V t, Index place, Nearest<V>& best) const {
    best.t = select(closer, t, best.t);
    best.place = select(closer, place, best.place);
  }

  [[gnu::noinline]] void update_tied(Mask met, Mask tied, V t, Index place, Nearest<V>& best) const {
    replace((met & (t < best.t)) | (tied & stands_before(tied, place, best.place)), t, place, best);
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

  GeometryId id_of(Whole whole) const {
    const auto place = static_cast<std::size_t>(whole);
    return place >= first_plane_ ? static_cast<GeometryId>(place - first_plane_) : scene_.spheres.id[place];
  }

  [[gnu::noinline]] void search_nearest(const Ray<V>& ray, Mask lanes, const Beam<T>& beam, const SphereGroup& group,
                                        Nearest<V>& best) const {
    const auto limit = [&]() RAYLAB_ATTRIBUTE { return as_limit(greatest_lane(select(lanes, best.t, V(-1)))); };
    const auto visit = [&](std::size_t i) RAYLAB_ATTRIBUTE {
      meet_sphere(ray, lanes, i, best);
      return true;
    };
    if (!spheres_.template search_beam<MetInOrder>(group, beam, lanes, limit, visit))
      search_nearest_each(ray, lanes, group, best);
  }

  void search_nearest_each(const Ray<V>& ray, Mask lanes, const SphereGroup& group, Nearest<V>& best) const {
    std::array<T, Lanes<V>::count> t;
    std::array<Whole, Lanes<V>::count> places;
    store(best.t, t.data());
    store(best.place, places.data());
    NearestLimits<Lanes<V>::count> limits(bits(lanes), t);
    spheres_.search_alone(group, ray, limits,
                          [&](std::size_t lane, const Alone<T>& alone, const SphereRow& spheres) RAYLAB_ATTRIBUTE {
                            if (nearer_of_spheres(alone, spheres, t[lane], places[lane])) limits.shorten(lane, t[lane]);
                          });
    best.t = load<V>(t.data());
    best.place = load_index<V>(places.data());
  }

  /// Does the ray meet one of the spheres before `t`? Then that becomes the nearest one's distance, and `place` its place.
  bool nearer_of_spheres(const Alone<T>& ray, const SphereRow& spheres, T& t, Whole& place) const {
    const Meeting<Row> meeting = spheres_.meet_spheres(ray, spheres);
    if (none(meeting.met)) return false;
    std::array<T, Lanes<Row>::count> distances;
    store(meeting.t, distances.data());
    const T before = t;
    for (std::uint32_t rest = bits(meeting.met); rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const T here = distances[static_cast<std::size_t>(lane)];
      const Whole candidate = static_cast<Whole>(spheres.begin) + lane;
      if (here < t || (here == t && id_of(candidate) < id_of(place))) {
        t = here;
        place = candidate;
      }
    }
    return t < before;
  }

  /// The vector from the center is put together from the foot and half the chord, not from the point and the center: far
  /// away these two are too close to each other.
  void on_sphere(const Ray<V>& ray, const Nearest<V>& nearest, const Places<V>& places, Mask lanes, Hit<V>& hit) const {
    const Ball<V> ball = spheres_.balls_at(places, lanes);
    const Passing<V> passing = pass(ray.origin, ray.direction, ball.center);
    if (any(starts_within(lanes, passing, ball.radius) | (lanes & ray.inwards))) [[unlikely]]
      return on_sphere_from_within(ray, nearest, ball, lanes, hit);
    const V half = meet_from_afar(lanes, passing, ball.radius).half;
    hit.inside = mask_of<V>(0);
    hit.normal = straightened((V(-1) / ball.radius) * (half * ray.direction + passing.perp));
  }

  [[gnu::noinline]] void on_sphere_from_within(const Ray<V>& ray, const Nearest<V>& nearest, const Ball<V>& ball, Mask lanes,
                                               Hit<V>& hit) const {
    const Passing<V> passing = pass(ray.origin, ray.direction, ball.center);
    const Meeting<V> meeting = meet(lanes, ray.origin, ray.direction, ball.center, ball.radius);
    const Mask own = lanes & ray.inwards & (ray.leaves == nearest.place);
    hit.inside = lanes & (own | meeting.inside);
    const V along = select(own, nearest.t - passing.foot, select(meeting.inside, meeting.half, -meeting.half));
    const Vec3<V> outwards = (V(1) / ball.radius) * (along * ray.direction - passing.perp);
    hit.normal = straightened(select(hit.inside, -outwards, outwards));
  }

  void on_plane(const Ray<V>& ray, std::size_t i, Hit<V>& hit) const {
    const Vec3<V> normal = spread<V>(scene_.planes[i].normal);
    hit.normal = select(dot(normal, ray.direction) > V(0), -normal, normal);
    hit.inside = mask_of<V>(0);
  }

  [[gnu::noinline]] void on_surfaces(const Ray<V>& ray, const Nearest<V>& nearest, const Places<V>& places, Mask met,
                                     Hit<V>& hit) const {
    hit.normal = zero<V>();
    hit.inside = mask_of<V>(0);
    const Mask spheres = met & (nearest.place < spheres_.all_at(first_plane_));
    if (any(spheres)) on_sphere(ray, nearest, places, spheres, hit);
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
      const Mask here = met & (nearest.place == spheres_.all_at(first_plane_ + i));
      if (none(here)) continue;
      Hit<V> there;
      on_plane(ray, i, there);
      hit.normal = select(here, there.normal, hit.normal);
      hit.inside = without(hit.inside, here);
    }
  }

  const Prepared<T>& scene_;
  const SphereSearch<V> spheres_;
  const std::size_t first_plane_;  ///< its place
  const T tile_growth_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
