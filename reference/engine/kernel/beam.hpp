// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// A ball around points: within `radius` of the one in lane `first`.
template <class T>
struct Area {
  std::size_t first;
  Point<T> middle;
  T radius;
};

/// All that is within a distance of a segment, which is `radius` where that starts, and grows.
template <class T>
struct Beam {
  Point<T> origin, direction;
  T radius;
  T growth;  ///< for each unit of length
  T length;
};

template <class V>
RAYLAB_INLINE NumberOf<V> lane(const V& a, std::size_t i) {
  static_assert(sizeof(V) == Lanes<V>::count * sizeof(NumberOf<V>));
  NumberOf<V> number;
  std::memcpy(&number, reinterpret_cast<const std::byte*>(&a) + i * sizeof number, sizeof number);
  return number;
}

template <class V>
RAYLAB_INLINE Point<NumberOf<V>> lane(const Vec3<V>& a, std::size_t i) {
  return {lane(a.x, i), lane(a.y, i), lane(a.z, i)};
}

template <class V>
RAYLAB_INLINE NumberOf<V> greatest_distance(const Vec3<V>& from, const Point<NumberOf<V>>& to, MaskOf<V> lanes) {
  const Vec3<V> apart = from - spread<V>(to);
  return std::sqrt(greatest_lane(select(lanes, dot(apart, apart), V(0))));
}

template <class V>
RAYLAB_INLINE Area<NumberOf<V>> area_of(const Vec3<V>& points, MaskOf<V> lanes) {
  // One from the middle of the tile, if there is one.
  constexpr std::uint32_t inner = Lanes<V>::count == 32   ? 0x3c3c00
                                  : Lanes<V>::count == 16 ? 0x0660
                                  : Lanes<V>::count == 8  ? 0x66
                                                          : ~0u;
  const std::uint32_t all = bits(lanes);
  const auto first = static_cast<std::size_t>(std::countr_zero((all & inner) != 0 ? all & inner : all));
  const Point<NumberOf<V>> middle = lane(points, first);
  return {first, middle, greatest_distance(points, middle, lanes)};
}

/// How far apart the directions of a tile's primary rays are, at most: no further than the samples in the image plane, whose
/// distance is one.
template <class V>
NumberOf<V> growth_of_tile(const PreparedCamera<NumberOf<V>>& camera) {
  using T = NumberOf<V>;
  const Vec3<T> diagonal = T(Tile<V>::width) * spread<T>(camera.right) + T(Tile<V>::height) * spread<T>(camera.up);
  return std::sqrt(dot(diagonal, diagonal));
}

template <class V>
RAYLAB_INLINE Beam<NumberOf<V>> beam_of(const Ray<V>& ray, MaskOf<V> lanes, V limit) {
  const Area<NumberOf<V>> start = area_of(ray.origin, lanes);
  const Point<NumberOf<V>> direction = lane(ray.direction, start.first);
  return {start.middle, direction, start.radius, greatest_distance(ray.direction, direction, lanes),
          greatest_lane(select(lanes, limit, V(0)))};
}

/// Of shadow rays that start in an area and run along `l` for `distance`: towards a point, or in parallel. In the lane of
/// area.first the light may be at the point itself; then the direction is NaN, and the beam may reach everything.
template <class V>
RAYLAB_INLINE Beam<NumberOf<V>> beam_of(const Area<NumberOf<V>>& area, const Vec3<V>& l, V distance) {
  return {area.middle, lane(l, area.first), area.radius, 0, lane(distance, area.first)};
}

}  // namespace raylab::fast::RAYLAB_TARGET
