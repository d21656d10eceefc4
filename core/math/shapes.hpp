#pragma once

#include "core/math/fields.hpp"
#include "core/math/vec3.hpp"

namespace raylab {

/// An infinite plane through `point`. Handout section 3.1.
struct Plane {
  Vec3 point;
  Vec3 normal{0, 1, 0};  ///< any non-zero length
};
RAYLAB_FIELDS(Plane, RAYLAB_FIELD(point) RAYLAB_FIELD(normal))

/// Handout section 3.2.
struct Sphere {
  Vec3 center;
  double radius = 1;  ///< > 0
};
RAYLAB_FIELDS(Sphere, RAYLAB_FIELD(center) RAYLAB_FIELD(radius))

}  // namespace raylab
