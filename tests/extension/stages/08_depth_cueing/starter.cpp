#include "stages/08_depth_cueing/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 8.1: what haze leaves of a color.
Color depth_cue(const Seen& seen) { RAYLAB_NOT_WRITTEN("8.1"); }

}  // namespace raylab::RAYLAB_IMPLEMENTATION
