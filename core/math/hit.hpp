#pragma once

#include "core/math/ray.hpp"

#include <optional>

namespace raylab {

/// One geometry's answer to a ray: the distance at which the ray meets it, or nothing for a miss.
struct Candidate {
  GeometryId geometry = no_geometry;
  std::optional<double> t;
};
RAYLAB_FIELDS(Candidate, RAYLAB_OPTIONAL_FIELD(geometry) RAYLAB_OPTIONAL_FIELD(t))

/// A surface point that a ray has reached.
struct Hit {
  double t = 0;    ///< the distance that the ray travelled
  Vec3 point;      ///< p
  Vec3 direction;  ///< d: the unit direction of the ray that came here; the view vector is V = -d
  Vec3 normal;     ///< N: unit, turned to the side that the ray came from (D8), so that d.N <= 0
  Leaves leaves;   ///< what a ray leaves that starts here on that side: this geometry, and which side of it that is
};
RAYLAB_FIELDS(Hit, RAYLAB_OPTIONAL_FIELD(t) RAYLAB_FIELD(point) RAYLAB_FIELD(direction) RAYLAB_FIELD(normal)
                       RAYLAB_OPTIONAL_FIELD(leaves))

/// A surface in the way of a shadow ray.
struct Crossing {
  double t = 0;              ///< distance from the shaded point, >= 0
  bool transparent = false;  ///< is it glass?
};
RAYLAB_FIELDS(Crossing, RAYLAB_FIELD(t) RAYLAB_OPTIONAL_FIELD(transparent))

/// A ray to trace next, and how much of the color at its end is added to the pixel.
struct Bounce {
  Ray ray;
  double weight = 0;  ///< 0 to 1
};
RAYLAB_FIELDS(Bounce, RAYLAB_FIELD(ray) RAYLAB_FIELD(weight))

/// The two rays that glass sends on. At total reflection `refracted.weight` is 0, and its ray means nothing.
struct GlassBounces {
  Bounce reflected;
  Bounce refracted;
};
RAYLAB_FIELDS(GlassBounces, RAYLAB_FIELD(reflected) RAYLAB_FIELD(refracted))

}  // namespace raylab
