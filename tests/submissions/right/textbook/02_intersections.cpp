#include "stages/02_intersections/stage.hpp"

#include <cmath>
#include <utility>

namespace raylab::RAYLAB_IMPLEMENTATION {

// The plane n.p = k.
std::optional<double> plane_hit(const Ray& ray, const Plane& plane) {
  const double k = glm::dot(plane.normal, plane.point);
  const double denominator = glm::dot(plane.normal, ray.direction);
  if (denominator == 0.0) return std::nullopt;
  const double t = (k - glm::dot(plane.normal, ray.origin)) / denominator;
  return t >= 0.0 ? std::optional<double>(t) : std::nullopt;
}

// a t^2 + b t + c = 0.
std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
  const Vec3 oc = ray.origin - sphere.center;
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = 2.0 * glm::dot(ray.direction, oc);
  const double c = glm::dot(oc, oc) - sphere.radius * sphere.radius;
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant < 0.0) return std::nullopt;
  double t0 = (-b - std::sqrt(discriminant)) / (2.0 * a);
  double t1 = (-b + std::sqrt(discriminant)) / (2.0 * a);
  if (t0 > t1) std::swap(t0, t1);
  if (t1 < 0.0) return std::nullopt;
  return t0 >= 0.0 ? t0 : t1;
}

Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) { return (point - sphere.center) / sphere.radius; }

std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
  double t_min = 1e30;
  int found = -1;
  for (int i = 0; i < static_cast<int>(candidates.size()); i++) {
    const Candidate& candidate = candidates[static_cast<std::size_t>(i)];
    if (candidate.t && *candidate.t < t_min) {
      t_min = *candidate.t;
      found = i;
    }
  }
  if (found < 0) return std::nullopt;
  return static_cast<std::size_t>(found);
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
