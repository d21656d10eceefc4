// The formulas as textbooks print them.
#include "stages/01_rays/stage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::RAYLAB_IMPLEMENTATION {

// The screen is as far away as makes a pixel one unit wide.
Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  const Vec3 w = -glm::normalize(camera.facing);
  const Vec3 u = glm::normalize(glm::cross(camera.up, w));
  const Vec3 v = glm::cross(w, u);

  const double theta = camera.half_field_of_view / 180.0 * std::numbers::pi;
  const double distance = 0.5 * std::max(width, height) * std::cos(theta) / std::sin(theta);

  Ray ray;
  ray.origin = camera.position;
  ray.direction = glm::normalize((x - 0.5 + dx) * u + (y - 0.5 + dy) * v - distance * w);
  return ray;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
