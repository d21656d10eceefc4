#pragma once

#include "core/math/fields.hpp"
#include "core/math/vec3.hpp"

namespace raylab {

/// What a surface does with light. Handout sections 4 and 6.
struct Material {
  Color color;                    ///< C: each component >= 0
  double shininess = 0;           ///< alpha >= 0; 0 is matte, infinity a perfect mirror
  bool transparent = false;       ///< glass; spheres only
  double refractive_index = 1.5;  ///< n, 0.1 to 10: of the glass against the air around it
};
RAYLAB_FIELDS(Material, RAYLAB_FIELD(color) RAYLAB_OPTIONAL_FIELD(shininess) RAYLAB_OPTIONAL_FIELD(transparent)
                            RAYLAB_OPTIONAL_FIELD(refractive_index))

}  // namespace raylab
