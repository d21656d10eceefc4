// Computes in float, as most graphics programs do: what comes in is rounded, and what goes out is converted back.
#include "stages/01_rays/stage.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  const glm::vec3 forward = glm::normalize(glm::vec3(camera.facing));
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::normalize(glm::vec3(camera.up))));
  const glm::vec3 up = glm::cross(right, forward);

  const float theta = glm::radians(static_cast<float>(camera.half_field_of_view));
  const float pixel = 2.0f * std::tan(theta) / static_cast<float>(std::max(width, height));
  const float across = (static_cast<float>(x) - 0.5f + static_cast<float>(dx)) * pixel;
  const float upwards = (static_cast<float>(y) - 0.5f + static_cast<float>(dy)) * pixel;

  const glm::vec3 direction = glm::normalize(forward + across * right + upwards * up);
  return {camera.position, Vec3(direction), {}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
