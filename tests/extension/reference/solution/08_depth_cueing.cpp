#include "stages/08_depth_cueing/stage.hpp"

#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 8.1: what haze leaves of a color.
Color depth_cue(const Seen& seen) {
  if (!seen.t) return seen.color;
  const double left = std::exp(-*seen.t / 20);
  return left * seen.color + (1 - left) * seen.background;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
