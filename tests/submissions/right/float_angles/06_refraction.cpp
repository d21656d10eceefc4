// Section 6 as the handout goes, with angles, and in float. Total reflection by rounding is black.
#include "stages/06_refraction/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

float angle_between(const glm::vec3& a, const glm::vec3& b) { return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)); }

/// The unit vector at `angle` from the unit vector n, in the plane of n and d, on d's side of n. Along n if d is.
glm::vec3 turned(const glm::vec3& n, const glm::vec3& d, float angle) {
  const glm::vec3 across = d - glm::dot(d, n) * n;
  if (glm::length(across) < 1e-6f) return n;
  return std::cos(angle) * n + std::sin(angle) * glm::normalize(across);
}

glm::vec3 mirrored(const glm::vec3& d, const glm::vec3& n) { return d - 2.0f * glm::dot(d, n) * n; }

float reflectance(float cosine, float index) {
  const float r0 = std::pow((1.0f - index) / (1.0f + index), 2.0f);
  return r0 + (1.0f - r0) * std::pow(1.0f - std::min(1.0f, std::max(0.0f, cosine)), 5.0f);
}

}  // namespace

std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const auto index = static_cast<float>(refractive_index);
  const glm::vec3 d(hit.direction), n(hit.normal), point(hit.point), center(sphere.center);
  const float theta1 = angle_between(-d, n);
  const float sin_theta2 = std::sin(theta1) / index;
  if (sin_theta2 > 1.0f) return std::nullopt;
  const float theta2 = std::asin(sin_theta2);
  const glm::vec3 inner = turned(-n, d, theta2);
  const glm::vec3 exit = point + 2.0f * static_cast<float>(sphere.radius) * std::cos(theta2) * inner;
  const glm::vec3 normal = glm::normalize(exit - center);

  const float sin_phi2 = index * std::sin(angle_between(inner, normal));
  if (sin_phi2 > 1.0f) return std::nullopt;
  return Ray{Vec3(exit), Vec3(turned(normal, inner, std::asin(sin_phi2))), hit.leaves};
}

double schlick(double cos_theta, double refractive_index) {
  return static_cast<double>(reflectance(static_cast<float>(cos_theta), static_cast<float>(refractive_index)));
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const auto index = static_cast<float>(refractive_index);
  const glm::vec3 d(hit.direction), n(hit.normal), point(hit.point);
  const Ray reflected{Vec3(point), Vec3(mirrored(d, n)), hit.leaves};

  const float angle = angle_between(-d, n);
  if (hit.leaves.side == Side::outwards) {
    if (std::sin(angle) > index) return {{reflected, 1.0}, {}};
    const auto r = static_cast<double>(reflectance(std::cos(angle), index));
    const std::optional<Ray> ray = through_sphere(sphere, refractive_index, hit);
    if (!ray) return {{reflected, r}, {}};
    return {{reflected, r}, {*ray, 1.0 - r}};
  }
  const float sine = index * std::sin(angle);
  if (sine > 1.0f) return {{reflected, 1.0}, {}};
  const float outer = std::asin(sine);
  const auto r = static_cast<double>(reflectance(std::cos(outer), index));
  return {{reflected, r}, {{Vec3(point), Vec3(turned(-n, d, outer)), {hit.leaves.geometry, Side::outwards}}, 1.0 - r}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
