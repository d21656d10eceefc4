// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// What may hide lights in a scene: nothing, so few spheres that all are asked, or many, in a hierarchy.
enum class Hiding { nothing, few, many };

/// A light as points see it.
template <class V>
struct Seen {
  Vec3<V> l;  ///< unit, towards the light
  V distance;
  const std::vector<LightPlane>& planes;
};

/// Finds out which points see a light.
template <class V>
class ShadowSearch {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;
  using Whole = WholeOf<V>;

  explicit ShadowSearch(const Prepared<T>& scene) : scene_(scene), spheres_(scene) {}

  /// What the planes of a light leave of the points that face it.
  struct PastPlanes {
    Mask lit;   ///< without those in the very plane that the light is in: the rounded L.N is not 0, and may be above it
    Mask open;  ///< and without those behind a plane
  };

  /// Apart, since few lights have such planes.
  [[gnu::noinline]] PastPlanes past_planes(const Hit<V>& hit, const std::vector<LightPlane>& planes, Mask lit) const {
    for (const auto& [plane, side] : planes)
      if (side == 0) lit = without(lit, hit.place == place_of_plane(plane));
    return {lit, not_behind_planes(hit, planes, lit)};
  }

  /// Those of `open` that no opaque sphere hides from the light.
  template <Hiding hiding>
  RAYLAB_INLINE Mask unblocked(const Hit<V>& hit, const Area<T>& area, const Seen<V>& light, Mask open) const {
    const SphereGroup& opaque = scene_.spheres.opaque;
    const Mask inside = open & hit.inside & (hit.place < spheres_.all_at(scene_.spheres.glass.begin));
    if (any(inside)) open = without(open, inside & far_side_blocks(hit, light, inside));
    const Beam<T> beam = beam_of(area, light.l, light.distance);
    spheres_.for_each_reached(beam, opaque.begin, opaque.loop_end, [&](std::size_t i) RAYLAB_ATTRIBUTE {
      open = without(open, blocked_by(hit, light, open, i));
      return any(open);
    });
    if constexpr (hiding == Hiding::many)
      if (any(open)) open = search_unblocked(hit, light, beam, open);
    return open;
  }

 private:
  using Row = typename SphereSearch<V>::Row;
  using SphereRow = typename SphereSearch<V>::SphereRow;

  Index place_of_plane(int i) const { return spheres_.all_at(scene_.first_plane() + static_cast<std::size_t>(i)); }

  Mask not_behind_planes(const Hit<V>& hit, const std::vector<LightPlane>& planes, Mask asked) const {
    for (const auto& [i, side] : planes) {
      if (side == 0) continue;
      const PreparedPlane<T>& plane = scene_.planes[static_cast<std::size_t>(i)];
      const V height = dot(hit.point - spread<V>(plane.point), spread<V>(plane.normal));
      const Mask behind = side > 0 ? height <= V(0) : height >= V(0);
      asked = without(asked, without(behind, hit.place == place_of_plane(i)));
    }
    return asked;
  }

  Mask far_side_blocks(const Hit<V>& hit, const Seen<V>& light, Mask lanes) const {
    return far_side(pass(hit.point, light.l, spheres_.centers(spheres_.spheres_at(hit.place, lanes)))) < light.distance;
  }

  RAYLAB_INLINE Mask blocked_by(const Hit<V>& hit, const Seen<V>& light, Mask open, std::size_t i) const {
    const Passing<V> passing = pass(hit.point, light.l, spheres_.center(i));
    const Mask close = spheres_.passing_close(open, i, passing);
    if (none(close)) return close;
    const Mask asked = without(close, hit.place == spheres_.all_at(i));
    const V radius = spheres_.radius(i);
    if (any(starts_within(asked, passing, radius))) [[unlikely]]
      return blocked_from_within(hit, light, asked, i);
    const Meeting<V> meeting = meet_from_afar(asked, passing, radius);
    return meeting.met & (meeting.t < light.distance);
  }

  // This and search_unblocked() take the light by value: by reference it would have to be in memory for those, too, that
  // need neither.
  [[gnu::noinline]] Mask blocked_from_within(const Hit<V>& hit, Seen<V> light, Mask asked, std::size_t i) const {
    const Meeting<V> meeting = meet(asked, hit.point, light.l, spheres_.center(i), spheres_.radius(i));
    return meeting.met & (meeting.t < light.distance);
  }

  [[gnu::noinline]] Mask search_unblocked(const Hit<V>& hit, Seen<V> light, const Beam<T>& beam, Mask open) const {
    const float longest = as_limit(greatest_lane(select(open, light.distance, V(-1))));
    const auto limit = [&]() RAYLAB_ATTRIBUTE { return any(open) ? longest : -1.0f; };
    const auto visit = [&](std::size_t i) RAYLAB_ATTRIBUTE {
      open = without(open, blocked_by(hit, light, open, i));
      return any(open);
    };
    if (spheres_.template search_beam<Met>(scene_.spheres.opaque, beam, open, limit, visit) || none(open)) return open;
    return search_unblocked_each({hit.point, light.l, hit.place, hit.inside}, light.distance, open);
  }

  Mask search_unblocked_each(const Ray<V>& shadow, V distance, Mask open) const {
    std::array<T, Lanes<V>::count> distances;
    store(distance, distances.data());
    AnyLimits<Lanes<V>::count> limits(bits(open), distances);
    spheres_.search_alone(scene_.spheres.opaque, shadow, limits,
                          [&](std::size_t lane, const Alone<T>& ray, const SphereRow& spheres) RAYLAB_ATTRIBUTE {
                            const Meeting<Row> meeting = spheres_.meet_spheres(ray, spheres);
                            if (any(meeting.met & (meeting.t < Row(distances[lane])))) limits.stop(lane);
                          });
    return mask_of<V>(limits.lanes());
  }

  const Prepared<T>& scene_;
  const SphereSearch<V> spheres_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
