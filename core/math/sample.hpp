#pragma once

#include "core/math/fields.hpp"

namespace raylab {

/// A place in a pixel, in pixels from its centre: dx to the right, dy up.
struct SampleOffset {
  double dx = 0;
  double dy = 0;
};
RAYLAB_FIELDS(SampleOffset, RAYLAB_FIELD(dx) RAYLAB_FIELD(dy))

}  // namespace raylab
