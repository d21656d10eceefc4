#pragma once

#ifndef GLM_FORCE_CTOR_INIT
#define GLM_FORCE_CTOR_INIT  // a vector that nobody set is zero, not whatever was in memory
#endif
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace raylab {

/// A point or a direction in world space, in scene units. `dot`, `cross` and `length` are GLM's.
using Vec3 = glm::dvec3;

/// Red, green and blue, each 0 for none; 1 is the brightest that an image shows. Not clamped until a pixel is finished.
using Color = glm::dvec3;

/// Is every component a finite number?
inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// `v` times the power of two that brings its largest component to 1..2: the same direction to the last bit, with squares
/// that neither vanish nor overflow. Zero, and what is no number, stays as it is.
inline Vec3 scaled(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || std::isinf(largest)) return v;
  const int exponent = std::ilogb(largest);
  return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

/// The unit vector along `v`. Any length is fine, even one whose square is too small or too large for a double. Zero, which
/// has no direction, stays zero.
inline Vec3 unit(const Vec3& v) {
  const double squared = glm::dot(v, v);
  if (squared > 1e-280 && squared < 1e280) return v / std::sqrt(squared);
  const Vec3 comparable = scaled(v);
  return v == Vec3(0) ? v : comparable / glm::length(comparable);
}

}  // namespace raylab
