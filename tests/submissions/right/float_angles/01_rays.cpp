#include "stages/01_rays/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

constexpr float pi = 3.14159265f;

glm::vec3 unit_of(const Vec3& v) {
  const glm::vec3 rounded(v);
  return rounded / std::sqrt(glm::dot(rounded, rounded));
}

}  // namespace

// Everything in units of half a screen, with nothing made unit before the end but the camera's axes.
Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  const glm::vec3 f = unit_of(camera.facing);
  const glm::vec3 u = unit_of(camera.up);
  const glm::vec3 r = glm::normalize(glm::cross(f, u));
  const glm::vec3 v = glm::cross(r, f);
  const float half = static_cast<float>(std::max(width, height)) / 2.0f;
  const float far = half / std::tan(static_cast<float>(camera.half_field_of_view) * pi / 180.0f);
  const glm::vec3 d = far * f + static_cast<float>(x - 0.5 + dx) * r + static_cast<float>(y - 0.5 + dy) * v;
  return {Vec3(glm::vec3(camera.position)), Vec3(d / std::sqrt(glm::dot(d, d))), {}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
