#pragma once

#include "core/math/camera.hpp"
#include "core/math/contract.hpp"
#include "core/math/ray.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 1.1: the ray from the camera through the point (dx, dy) off the centre of a pixel.
/// width, height: the image in pixels. x, y: the pixel in the handout's screen coordinates, x to the right and y up, whole
/// or half numbers, so that (x - 1/2, y - 1/2) is the pixel's centre measured from the middle of the image.
/// dx, dy: in pixels, each from -1/2 to 1/2; 0, 0 is the centre.
/// Returns a ray that starts at the camera's position, with a unit direction, and leaves nothing. Handout section 2.
Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_01_RAYS(TASK)                                                      \
  TASK("1.1", camera_ray, "the ray through a pixel",                                    \
       R"({"camera": {"position": [0, 1, 5], "facing": [0, 0, -1], "up": [0, 1, 0]}, )" \
       R"("width": 640, "height": 480, "x": 1, "y": 0, "dx": 0, "dy": 0})")
