#include "stages/02_intersections/stage.hpp"

#include <cmath>
#include <limits>

namespace raylab::RAYLAB_IMPLEMENTATION {

std::optional<double> plane_hit(const Ray& ray, const Plane& plane) {
  const glm::vec3 o(ray.origin), d(ray.direction), c(plane.point);
  const glm::vec3 n = glm::normalize(glm::vec3(plane.normal));
  const float slope = glm::dot(d, n);
  if (std::abs(slope) < 1e-6f) return std::nullopt;
  const float t = glm::dot(c - o, n) / slope;
  if (t < 0.0f) return std::nullopt;
  return static_cast<double>(t);
}

std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
  const glm::vec3 d(ray.direction);
  const glm::vec3 f = glm::vec3(ray.origin) - glm::vec3(sphere.center);
  const auto radius = static_cast<float>(sphere.radius);
  const float b = 2.0f * glm::dot(f, d);
  const float c = glm::dot(f, f) - radius * radius;
  const float discriminant = b * b - 4.0f * c;
  if (discriminant < 0.0f) return std::nullopt;
  const float root = std::sqrt(discriminant);
  const float near = (-b - root) / 2.0f;
  if (near >= 0.0f) return static_cast<double>(near);
  const float far = (-b + root) / 2.0f;
  if (far >= 0.0f) return static_cast<double>(far);
  return std::nullopt;
}

Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) {
  return Vec3(glm::normalize(glm::vec3(point) - glm::vec3(sphere.center)));
}

std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
  float best = std::numeric_limits<float>::infinity();
  std::optional<std::size_t> index;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!candidates[i].t.has_value()) continue;
    const auto t = static_cast<float>(*candidates[i].t);
    if (t < best) {
      best = t;
      index = i;
    }
  }
  return index;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
