#pragma once

// What renderers in double do to rays: for the sensitivity of a pixel.
#include "reference/oracle/formulas.hpp"

#include <cmath>
#include <cstdint>

namespace raylab::oracle {

/// Each component rounded to the nearest double.
template <class T>
Ray<T> round_to_nearest(const Ray<T>& ray, std::uint64_t) {
  const auto nearest = [](const T& x) { return T(x.template convert_to<double>()); };
  const auto rounded = [&](const Vec3<T>& v) { return Vec3<T>(nearest(v.x), nearest(v.y), nearest(v.z)); };
  return {rounded(ray.origin), rounded(ray.direction), ray.leaves};
}

/// Each component moved up or down, as chance has it, by half a unit in the last place of its vector's largest one: where a
/// component is small, rounding in the sums that gave it is not. The same chances in every run.
template <class T, std::uint64_t seed>
Ray<T> round_at_random(const Ray<T>& ray, std::uint64_t number) {
  std::uint64_t bits = (number + 1) * 0x9e3779b97f4a7c15u + seed * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 31)) * 0x94d049bb133111ebu;
  const auto moved = [&](const Vec3<T>& v) {
    const double largest = size(v).template convert_to<double>();
    const T half = ldexp(T(1), largest > 0 ? std::ilogb(largest) - 53 : -1100);
    const auto step = [&] {
      bits = (bits << 1) | (bits >> 63);
      return bits & 1 ? half : T(-half);
    };
    const T x = v.x + step();
    const T y = v.y + step();
    return Vec3<T>(x, y, v.z + step());
  };
  const bool given = ray.leaves.geometry == no_geometry;  // the camera's place is exact
  const Vec3<T> origin = given ? ray.origin : moved(ray.origin);
  return {origin, moved(ray.direction), ray.leaves};
}

}  // namespace raylab::oracle
