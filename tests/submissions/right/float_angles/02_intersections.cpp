// In float and by the formulas that lose most digits there: whatever passes a float has to be this far from the right
// answer.
#include "stages/02_intersections/stage.hpp"

#include <glm/exponential.hpp>

#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

std::optional<double> plane_hit(const Ray& ray, const Plane& plane) {
  const glm::vec3 n(plane.normal);
  const float slope = glm::dot(n, glm::vec3(ray.direction));
  if (slope == 0.0f) return std::nullopt;
  const float t = (glm::dot(n, glm::vec3(plane.point)) - glm::dot(n, glm::vec3(ray.origin))) / slope;
  return t >= 0.0f ? std::optional<double>(static_cast<double>(t)) : std::nullopt;
}

std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
  const glm::vec3 o(ray.origin), d(ray.direction), center(sphere.center);
  const auto radius = static_cast<float>(sphere.radius);
  const float a = glm::dot(d, d);
  const float b = 2.0f * (glm::dot(o, d) - glm::dot(center, d));
  const float c = glm::dot(o, o) + glm::dot(center, center) - 2.0f * glm::dot(o, center) - radius * radius;
  const float discriminant = b * b - 4.0f * a * c;
  if (discriminant < 0.0f) return std::nullopt;
  const float near = (-b - std::sqrt(discriminant)) / (2.0f * a), far = (-b + std::sqrt(discriminant)) / (2.0f * a);
  if (far < 0.0f) return std::nullopt;
  return static_cast<double>(near < 0.0f ? far : near);
}

Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) {
  const glm::vec3 outwards = glm::vec3(point) - glm::vec3(sphere.center);
  return Vec3(outwards * glm::inversesqrt(glm::dot(outwards, outwards)));
}

std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
  std::optional<std::size_t> best;
  for (std::size_t k = candidates.size(); k-- > 0;)
    if (candidates[k].t && (!best || static_cast<float>(*candidates[k].t) <= static_cast<float>(*candidates[*best].t)))
      best = k;
  return best;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
