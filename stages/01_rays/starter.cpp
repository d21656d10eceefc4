// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/01_rays/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 1.1: the ray through a pixel.
Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  RAYLAB_NOT_WRITTEN("1.1");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
