#pragma once

#include "core/math/fields.hpp"
#include "core/math/vec3.hpp"

namespace raylab {

/// Light from one point, weaker with distance. Handout section 1.
struct PointLight {
  Vec3 position;
  double intensity = 0;  ///< I >= 0
};
RAYLAB_FIELDS(PointLight, RAYLAB_FIELD(position) RAYLAB_FIELD(intensity))

/// Light from very far away, equally strong everywhere, as the sun's. Handout section 1.
struct DirectionalLight {
  Vec3 direction{0, -1, 0};  ///< the way the light travels; any non-zero length
  double intensity = 0;      ///< I >= 0
};
RAYLAB_FIELDS(DirectionalLight, RAYLAB_FIELD(direction) RAYLAB_FIELD(intensity))

/// The same light on every point, from everywhere. Handout section 1.
struct AmbientLight {
  double intensity = 0;  ///< I >= 0
};
RAYLAB_FIELDS(AmbientLight, RAYLAB_FIELD(intensity))

}  // namespace raylab
