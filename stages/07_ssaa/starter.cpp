// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/07_ssaa/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 7.1: where a pixel's samples lie.
std::vector<SampleOffset> sample_positions() {
  RAYLAB_NOT_WRITTEN("7.1");
}

// Task 7.2: from samples to the pixel's color.
Color resolve(std::span<const Color> samples) {
  RAYLAB_NOT_WRITTEN("7.2");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
