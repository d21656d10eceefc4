// Section 6 as the handout goes, with angles.
#include "stages/06_refraction/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

double angle_between(const Vec3& a, const Vec3& b) { return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)); }

/// The unit vector at `angle` from the unit vector n, in the plane of n and d, on d's side of n. Along n if d is.
Vec3 turned(const Vec3& n, const Vec3& d, double angle) {
  const Vec3 across = d - glm::dot(d, n) * n;
  if (glm::length(across) < 1e-12) return n;
  return std::cos(angle) * n + std::sin(angle) * glm::normalize(across);
}

Vec3 mirrored(const Vec3& d, const Vec3& n) { return d - 2.0 * glm::dot(d, n) * n; }

}  // namespace

std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const double theta1 = angle_between(-hit.direction, hit.normal);
  const double sin_theta2 = std::sin(theta1) / refractive_index;
  if (sin_theta2 > 1.0) return std::nullopt;
  const double theta2 = std::asin(sin_theta2);
  const Vec3 inner = turned(-hit.normal, hit.direction, theta2);

  // The second point: the quadratic's other root, since the first one is here.
  const double t = -2.0 * glm::dot(inner, hit.point - sphere.center);
  const Vec3 exit = hit.point + t * inner;
  const Vec3 normal = glm::normalize(exit - sphere.center);

  const double phi1 = angle_between(inner, normal);
  const double sin_phi2 = refractive_index * std::sin(phi1);
  const double phi2 = sin_phi2 > 1.0 ? theta1 : std::asin(sin_phi2);
  return Ray{exit, turned(normal, inner, phi2), hit.leaves};
}

double schlick(double cos_theta, double refractive_index) {
  const double r0 = std::pow((1.0 - refractive_index) / (1.0 + refractive_index), 2.0);
  return r0 + (1.0 - r0) * std::pow(1.0 - std::min(1.0, std::max(0.0, cos_theta)), 5.0);
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  GlassBounces result;
  result.reflected.ray = {hit.point, mirrored(hit.direction, hit.normal), hit.leaves};
  result.reflected.weight = 1.0;

  const double angle = angle_between(-hit.direction, hit.normal);
  double cosine = std::cos(angle);
  if (hit.leaves.side == Side::outwards) {
    const std::optional<Ray> ray = through_sphere(sphere, refractive_index, hit);
    if (!ray) return result;
    result.refracted.ray = *ray;
  } else {
    const double sine = refractive_index * std::sin(angle);
    if (sine > 1.0) return result;
    const double outer = std::asin(sine);
    cosine = std::cos(outer);
    result.refracted.ray = {hit.point, turned(-hit.normal, hit.direction, outer), {hit.leaves.geometry, Side::outwards}};
  }
  const double r = schlick(cosine, refractive_index);
  result.reflected.weight = r;
  result.refracted.weight = 1.0 - r;
  return result;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
