// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// Two numbers whose sum is exactly the result of an operation; `tail` is what rounding `value` left out.
template <class V>
struct Exact {
  V value;
  V tail;
};

/// a + b (Knuth).
template <class V>
RAYLAB_INLINE Exact<V> exact_sum(V a, V b) {
  const V sum = a + b;
  const V b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a * a, if it neither overflows nor loses bits below the smallest number: the halves of `a` have exact products (Veltkamp,
/// Dekker). A fused multiply-add would give the same bits, where there is one.
template <class V>
RAYLAB_INLINE Exact<V> exact_square(V a) {
  using T = NumberOf<V>;
  constexpr T splitter = T(1ull << ((std::numeric_limits<T>::digits + 1) / 2)) + T(1);
  const V square = a * a;
  const V scaled = V(splitter) * a;
  const V high = scaled - (scaled - a);
  const V low = a - high;
  return {square, ((high * high - square) + V(T(2)) * high * low) + low * low};
}

/// |a - c|^2 - radius^2: how far outside (> 0) or inside (< 0) a sphere around `c` the point `a` is, with an error of a few
/// roundings of the *result*. Plain arithmetic has an error of radius^2 instead: for a camera on the ground of a giant
/// sphere that is more than its height.
template <class V>
V gap_to_sphere(Vec3<V> a, Vec3<V> c, V radius) {
  const Exact<V> x = exact_sum(a.x, -c.x), y = exact_sum(a.y, -c.y), z = exact_sum(a.z, -c.z);
  const Exact<V> x2 = exact_square(x.value), y2 = exact_square(y.value), z2 = exact_square(z.value);
  const Exact<V> r2 = exact_square(radius);
  const Exact<V> xy = exact_sum(x2.value, y2.value);
  const Exact<V> xyz = exact_sum(xy.value, z2.value);
  const Exact<V> gap = exact_sum(xyz.value, -r2.value);
  const V squares = x2.tail + y2.tail + z2.tail - r2.tail;
  const V differences = V(2) * (x.value * x.tail + y.value * y.tail + z.value * z.tail);
  return gap.value + (gap.tail + xyz.tail + xy.tail + squares + differences);
}

}  // namespace raylab::fast::RAYLAB_TARGET
