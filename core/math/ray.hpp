#pragma once

#include "core/math/fields.hpp"
#include "core/math/vec3.hpp"

namespace raylab {

/// The number of a geometry in its scene: planes first, then spheres, then the spheres of clouds, each in file order.
using GeometryId = int;
inline constexpr GeometryId no_geometry = -1;

/// The side of a surface on which a ray travels. A plane has no inside: every ray is `outwards` of it.
enum class Side { outwards, inwards };
RAYLAB_NAMES(Side, RAYLAB_NAME(outwards) RAYLAB_NAME(inwards))

/// The surface that a ray starts on, and the side on which it starts; `no_geometry` for a ray that starts in free space.
/// It says what rounded numbers cannot: whether the ray may meet that surface again (docs/model.md, D6).
struct Leaves {
  GeometryId geometry = no_geometry;
  Side side = Side::outwards;
};
RAYLAB_FIELDS(Leaves, RAYLAB_FIELD(geometry) RAYLAB_OPTIONAL_FIELD(side))

/// All points `origin + t direction` with `t >= 0`. `direction` is a unit vector, so `t` is a distance (D4).
struct Ray {
  Vec3 origin;
  Vec3 direction;
  Leaves leaves;
};
RAYLAB_FIELDS(Ray, RAYLAB_FIELD(origin) RAYLAB_FIELD(direction) RAYLAB_OPTIONAL_FIELD(leaves))

}  // namespace raylab
