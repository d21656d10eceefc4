#pragma once

#include "core/math/fields.hpp"
#include "core/math/ray.hpp"

#include <optional>

namespace raylab {

/// What was seen along one ray, camera's or bounced.
struct Seen {
  Color color;  ///< at the end of the ray, with all that its own bounces brought
  Ray ray;
  std::optional<double> t;  ///< the distance to what the ray met; nothing if it met nothing
  Color background;         ///< the scene's
  int bounce = 0;           ///< 0 for the camera's ray
};
RAYLAB_FIELDS(Seen, RAYLAB_FIELD(color) RAYLAB_FIELD(ray) RAYLAB_OPTIONAL_FIELD(t) RAYLAB_OPTIONAL_FIELD(background)
                        RAYLAB_OPTIONAL_FIELD(bounce))

/// A task that the driver asks once for every ray that it has followed, with what was seen along it, for the color to use
/// instead. Stages after the seventh join the driver in this way: each of their tasks with this type is asked, in order.
using RayFilter = Color (*)(const Seen&);

}  // namespace raylab
