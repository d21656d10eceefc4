#pragma once

#include "reference/engine/vec3.hpp"

#include <cmath>
#include <limits>

namespace raylab::fast {

/// Two numbers whose sum is exactly the result of an operation; `tail` is what rounding `value` left out.
template <class T>
struct Exact {
  T value;
  T tail;
};

/// a + b (Knuth).
template <class T>
constexpr Exact<T> exact_sum(T a, T b) {
  const T sum = a + b;
  const T b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a * a, if it neither overflows nor loses bits below the smallest number. With or without FMA the bits are the same:
/// without, each factor is split into halves whose products are exact (Veltkamp, Dekker).
template <class T>
constexpr Exact<T> exact_square(T a) {
  const T square = a * a;
#ifdef __FMA__
  return {square, std::fma(a, a, -square)};
#else
  constexpr T splitter = T(1ull << ((std::numeric_limits<T>::digits + 1) / 2)) + T(1);
  const T scaled = splitter * a;
  const T high = scaled - (scaled - a);
  const T low = a - high;
  return {square, ((high * high - square) + T(2) * high * low) + low * low};
#endif
}

/// |a - c|^2 - radius^2: how far outside (> 0) or inside (< 0) a sphere around `c` the point `a` is, with an error of a few
/// roundings of the *result*. Plain arithmetic has an error of radius^2 instead: for a camera on the ground of a giant
/// sphere that is more than its height.
template <class T>
constexpr T gap_to_sphere(const Vec3<T>& a, const Vec3<T>& c, T radius) {
  const Exact<T> x = exact_sum(a.x, -c.x), y = exact_sum(a.y, -c.y), z = exact_sum(a.z, -c.z);
  const Exact<T> x2 = exact_square(x.value), y2 = exact_square(y.value), z2 = exact_square(z.value);
  const Exact<T> r2 = exact_square(radius);
  const Exact<T> xy = exact_sum(x2.value, y2.value);
  const Exact<T> xyz = exact_sum(xy.value, z2.value);
  const Exact<T> gap = exact_sum(xyz.value, -r2.value);
  const T squares = x2.tail + y2.tail + z2.tail - r2.tail;
  const T differences = T(2) * (x.value * x.tail + y.value * y.tail + z.value * z.tail);
  return gap.value + (gap.tail + xyz.tail + xy.tail + squares + differences);
}

}  // namespace raylab::fast
