// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

template <class V>
struct Ball {
  Vec3<V> center;
  V radius;
};

/// How rays, or a beam of them, meet the spheres of a scene: what the search for the nearest surface and the search for
/// shadows share.
template <class V>
class SphereSearch {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;
  using Whole = WholeOf<V>;
  using Row = SingleOf<V>;  ///< spheres side by side, that one ray or beam asks
  static_assert(Lanes<Row>::count <= Spheres<T>::padding);

  explicit SphereSearch(const Prepared<T>& scene) : scene_(scene) {}

  /// A place in all lanes.
  static Index all_at(std::size_t place) { return Index(static_cast<Whole>(place)); }

  /// The places of the spheres that are in `lanes`; 0 in the others.
  static Index spheres_at(Index place, Mask lanes) { return select(lanes, place, Index(0)); }

  Vec3<V> centers(Index sphere) const {
    const PointArray<T>& center = scene_.spheres.center;
    return {gather(center.x.data(), sphere), gather(center.y.data(), sphere), gather(center.z.data(), sphere)};
  }

  Vec3<V> center(std::size_t i) const { return spread<V>(scene_.spheres.center[i]); }

  /// Each lane's sphere; the first one in the lanes that have none.
  Ball<V> balls_at(const Places<V>& places, Mask lanes) const {
    if (places.same()) {
      const auto sphere = static_cast<std::size_t>(places.common());
      return {center(sphere), radius(sphere)};
    }
    const Index sphere = spheres_at(places.each(), lanes);
    return {centers(sphere), gather(scene_.spheres.radius.data(), sphere)};
  }

  /// Lanes whose line passes sphere i closely enough.
  RAYLAB_INLINE Mask passing_close(Mask lanes, std::size_t i, const Passing<V>& passing) const {
    return lanes & (passing.apart <= V(scene_.spheres.reach[i]));
  }

  V radius(std::size_t i) const { return V(scene_.spheres.radius[i]); }

  /// Spheres side by side. What stands behind a leaf is among them, too: it does no harm.
  struct SphereRow {
    std::size_t begin;  ///< the place of the first
    Vec3<Row> center;
    Row reach;
    IndexOf<Row> place;
  };

  /// From place i on.
  RAYLAB_INLINE SphereRow spheres_from(std::size_t i) const {
    const Spheres<T>& spheres = scene_.spheres;
    return {i,
            {load<Row>(&spheres.center.x[i]), load<Row>(&spheres.center.y[i]), load<Row>(&spheres.center.z[i])},
            load<Row>(&spheres.reach[i]),
            lane_numbers<Row>() + IndexOf<Row>(static_cast<Whole>(i))};
  }

  RAYLAB_INLINE Meeting<Row> meet_spheres(const Alone<T>& ray, const SphereRow& spheres) const {
    const Vec3<Row> o = spread<Row>(ray.origin), d = spread<Row>(ray.direction);
    const Passing<Row> passing = pass(o, d, spheres.center);
    const MaskOf<Row> asked = without(passing.apart <= spheres.reach, spheres.place == IndexOf<Row>(ray.leaves));
    if (none(asked)) return {asked, Row(0), Row(0), asked};
    const Row radius = load<Row>(&scene_.spheres.radius[spheres.begin]);
    if (any(starts_within(asked, passing, radius))) [[unlikely]]
      return meet(asked, o, d, spheres.center, radius);
    return meet_from_afar(asked, passing, radius);
  }

  /// Calls visit(lane, ray, spheres) for each ray and the spheres of the leaves that it may meet as far as `limits` allow,
  /// which that call may shorten.
  template <class Limits, class Visit>
  RAYLAB_INLINE void search_alone(const SphereGroup& group, const Ray<V>& ray, const Limits& limits, Visit visit) const {
    const Singles<V> rays(ray);
    const auto leaf = [&](std::size_t begin, std::size_t count, std::uint32_t lanes) RAYLAB_ATTRIBUTE {
      const std::size_t first = group.loop_end + begin;
      for (std::size_t i = first; i < first + count; i += Lanes<Row>::count) {
        const SphereRow spheres = spheres_from(i);
        for (std::uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
          visit(lane, rays.ray(lane), spheres);
        }
      }
    };
    search_each(*group.hierarchy, rays.probes(*group.hierarchy), limits, leaf);
  }

  /// Calls visit(i) for the spheres from `begin` up to `end` that the beam reaches, until it returns false.
  template <class Visit>
  RAYLAB_INLINE void for_each_reached(const Beam<T>& beam, std::size_t begin, std::size_t end, Visit visit) const {
    if (begin == end) return;
    if (Lanes<V>::count == 1 || !(beam.growth < fastest_growth)) {
      for (std::size_t i = begin; i < end; ++i)
        if (!visit(i)) return;
      return;
    }
    for (std::size_t i = begin; i < end; i += Lanes<Row>::count)
      for (std::uint32_t near = reached(beam, i, end); near != 0; near &= near - 1)
        if (!visit(i + static_cast<std::size_t>(std::countr_zero(near)))) return;
  }

  /// Calls visit(i) for the spheres that the beam of `lanes` reaches, up to limit(), until that is below 0 or visit()
  /// returns false. False: gave up, or did not begin. `Children` as in Stack.
  template <class Children, class Limit, class Visit>
  RAYLAB_INLINE bool search_beam(const SphereGroup& group, const Beam<T>& beam, Mask lanes, Limit limit, Visit visit) const {
    if (count(lanes) < least_together || !(beam.growth < widest_together) || std::isnan(beam.direction.x)) return false;
    int leaves = most_leaves_together;
    const auto leaf = [&](std::size_t begin, std::size_t count) RAYLAB_ATTRIBUTE {
      for_each_reached(beam, group.loop_end + begin, group.loop_end + begin + count, visit);
      return --leaves > 0 ? limit() : -1.0f;
    };
    search_together<Children>(*group.hierarchy, probe_for(beam, *group.hierarchy), limit(), leaf);
    return leaves > 0;
  }

 private:
  /// A hierarchy is searched for the rays of a pack together where they are some, and stay together; if they turn out to
  /// meet too many leaves, or are few, for each of them alone.
  static constexpr std::size_t least_together = 6;
  static constexpr T widest_together = T(0.1);
  static constexpr int most_leaves_together = 6;

  /// Bit k: may a ray of the beam meet sphere begin + k, before `end`? A hit is at most 2 (R + radius) / (1 - growth)
  /// further along than the sphere's center, and a beam that grows faster than this reaches everything.
  static constexpr T fastest_growth = T(0.25);

  std::uint32_t reached(const Beam<T>& beam, std::size_t begin, std::size_t end) const {
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

  static Probes<1> probe_for(const Beam<T>& beam, const Hierarchy& hierarchy) {
    const auto [x, y, z] = beam.origin;
    const auto [a, b, c] = beam.direction;
    const std::array<double, 3>& middle = hierarchy.middle();
    const double to_middle = std::max({std::abs(x - middle[0]), std::abs(y - middle[1]), std::abs(z - middle[2])});
    const double farthest = std::min<double>(beam.length, 2 * (to_middle + hierarchy.extent()));
    return {hierarchy, Probes<1>::Vectors<T>{{{x}, {y}, {z}}}, {{{a}, {b}, {c}}}, beam.radius + beam.growth * farthest};
  }

  const Prepared<T>& scene_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
