// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// A vector of single numbers, or a vector in each lane of a pack.
template <class V>
struct Vec3 {
  V x, y, z;

  friend RAYLAB_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend RAYLAB_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend RAYLAB_INLINE Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend RAYLAB_INLINE Vec3 operator*(V s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class V>
RAYLAB_INLINE Vec3<V> zero() {
  return {V(0), V(0), V(0)};
}

/// The same vector in every lane.
template <class V>
RAYLAB_INLINE Vec3<V> spread(const Point<NumberOf<V>>& a) {
  return {V(a.x), V(a.y), V(a.z)};
}

template <class V>
RAYLAB_INLINE V dot(const Vec3<V>& a, const Vec3<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class V>
RAYLAB_INLINE Vec3<V> select(MaskOf<V> condition, const Vec3<V>& yes, const Vec3<V>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}

/// From 0 to 1. A NaN stays one: the program counts and reports it.
template <class V>
RAYLAB_INLINE V clamped(V a) {
  return least(V(1), greatest(V(0), a));
}

/// `a`, already a unit vector but for a few roundings, with those taken back: one Newton step. Without it the length of a
/// ray that bounces often would drift.
template <class V>
RAYLAB_INLINE Vec3<V> straightened(const Vec3<V>& a) {
  return (V(1.5f) - V(0.5f) * dot(a, a)) * a;
}

/// The mirror image of a direction at a unit normal.
template <class V>
RAYLAB_INLINE Vec3<V> mirrored(const Vec3<V>& d, const Vec3<V>& n) {
  return straightened(d - (V(2) * dot(d, n)) * n);
}

}  // namespace raylab::fast::RAYLAB_TARGET
