#pragma once

#include "core/math/fields.hpp"
#include "core/math/vec3.hpp"

namespace raylab {

/// Where the picture is taken from. Handout sections 1 and 2.
struct Camera {
  Vec3 position;
  Vec3 facing{0, 0, -1};           ///< f: any non-zero length
  Vec3 up{0, 1, 0};                ///< u: any non-zero length, not parallel to `facing`
  double half_field_of_view = 45;  ///< theta, in degrees: from the axis to the middle of the longer side's edge (D1)
};
RAYLAB_FIELDS(Camera, RAYLAB_FIELD(position) RAYLAB_FIELD(facing) RAYLAB_FIELD(up) RAYLAB_OPTIONAL_FIELD(half_field_of_view))

}  // namespace raylab
