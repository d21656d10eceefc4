// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Where the light of a point comes from.
template <class V>
struct PointSeen {
  Vec3<V> l;  ///< unit, towards it; NaN, above no surface, where the light is at the point itself
  V distance;
  V fall_off;  ///< 1 / (1 + distance)
};

/// By one division for both 1/r and 1/(1 + r).
template <class V>
RAYLAB_INLINE PointSeen<V> see_point(const Vec3<V>& from, const Vec3<V>& light) {
  using T = NumberOf<V>;
  Vec3<V> way = light - from;
  V squared = dot(way, way);
  const MaskOf<V> near = squared < V(std::numeric_limits<T>::min());
  if (any(near)) [[unlikely]] {
    // The square vanishes, and with it the direction. 1 + r is 1 for a larger r, too.
    constexpr T larger = sizeof(T) == sizeof(float) ? T(0x1p38) : T(0x1p451);
    way = select(near, V(larger), V(1)) * way;
    squared = dot(way, way);
  }
  const V r = square_root(squared);
  const V beyond = V(1) + r;
  const V inverse = V(1) / (r * beyond);
  return {(inverse * beyond) * way, r, inverse * r};
}

/// Light beyond the largest number is infinite, but black stays black.
template <class V>
RAYLAB_INLINE Vec3<V> tinted(V light, const Vec3<V>& color) {
  const auto part = [light](V c) RAYLAB_ATTRIBUTE { return select(c > V(0), light * c, V(0)); };
  return {part(color.x), part(color.y), part(color.z)};
}

/// All light that surfaces send back, but for what mirrors and glass show.
template <class V>
class Lighting {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;
  using Whole = WholeOf<V>;

  explicit Lighting(const Prepared<T>& scene) : scene_(scene), shadows_(scene) {}

  /// All the light that surfaces send back against `d`, but for their colors.
  RAYLAB_INLINE V light_on(const Hit<V>& hit, const Vec3<V>& d, const Look<V>& look, Mask lit, RayCounts& counts) const {
    if (scene_.features.highlights) return light_as_hidden<true>(hit, d, look, lit, counts);
    return light_as_hidden<false>(hit, d, look, lit, counts);
  }

 private:
  template <bool highlights>
  RAYLAB_INLINE V light_as_hidden(const Hit<V>& hit, const Vec3<V>& d, const Look<V>& look, Mask lit,
                                  RayCounts& counts) const {
    if (!scene_.features.shadows) return all_lights<highlights, Hiding::nothing>(hit, d, look, lit, counts);
    if (!scene_.spheres.opaque.hierarchy) return all_lights<highlights, Hiding::few>(hit, d, look, lit, counts);
    return all_lights<highlights, Hiding::many>(hit, d, look, lit, counts);
  }

  /// Functions of their own for scenes without highlights, or with less that may hide lights: in one for all these would
  /// keep registers busy.
  template <bool highlights, Hiding hiding>
  [[gnu::noinline]] V all_lights(const Hit<V>& hit, const Vec3<V>& d, const Look<V>& look, Mask lit,
                                 RayCounts& counts) const {
    V sum(scene_.ambient);
    const Area<T> area = hiding != Hiding::nothing ? area_of(hit.point, lit) : Area<T>{};
    for (const PreparedPointLight<T>& light : scene_.point_lights) {
      const PointSeen<V> point = see_point(hit.point, spread<V>(light.position));
      const V strength = V(light.intensity) * (point.fall_off * point.fall_off);
      sum = sum + light_from<highlights, hiding>({point.l, point.distance, light.planes}, strength, hit, area, d, look, lit,
                                                 counts);
    }
    for (const PreparedDirectionalLight<T>& light : scene_.directional_lights) {
      const Seen<V> seen = {spread<V>(light.l), V(std::numeric_limits<T>::infinity()), light.planes};
      sum = sum + light_from<highlights, hiding>(seen, V(light.intensity), hit, area, d, look, lit, counts);
    }
    return sum;
  }

  /// 0 where the light is not seen; from so far away that distances are infinite, it is not.
  template <bool highlights, Hiding hiding>
  RAYLAB_INLINE V light_from(const Seen<V>& light, V strength, const Hit<V>& hit, const Area<T>& area, const Vec3<V>& d,
                             const Look<V>& look, Mask lit, RayCounts& counts) const {
    const V cosine = dot(light.l, hit.normal);
    lit = lit & (cosine > V(0));
    Mask open = lit;
    if (!light.planes.empty()) [[unlikely]] {
      const typename ShadowSearch<V>::PastPlanes past = shadows_.past_planes(hit, light.planes, lit);
      lit = past.lit;
      open = past.open;
    }
    if (none(lit)) return V(0);
    if constexpr (hiding != Hiding::nothing) {
      counts.shadow += count(lit);
      lit = shadows_.template unblocked<hiding>(hit, area, light, open);
      if (none(lit)) return V(0);
    }
    const V shown = highlights ? cosine + shine(light, hit, d, look, lit) : cosine;
    return select(lit, shown * strength, V(0));
  }

  RAYLAB_INLINE V shine(const Seen<V>& light, const Hit<V>& hit, const Vec3<V>& d, const Look<V>& look, Mask lit) const {
    const V k_s = look[strength];
    return k_s * highlight(lit & (k_s > V(0)), light.l, hit.normal, -d, look[alpha]);
  }

  const Prepared<T>& scene_;
  const ShadowSearch<V> shadows_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
