// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/04_shadows/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 4.1: is the light kept from a point?
bool blocked(std::span<const Crossing> crossings, double distance) {
  RAYLAB_NOT_WRITTEN("4.1");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
