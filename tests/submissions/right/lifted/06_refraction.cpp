#include "stages/06_refraction/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

constexpr double lift = 1e-4;

/// glm::refract() gives the zero vector where nothing is refracted.
bool is_zero(const Vec3& v) { return v == Vec3(0.0); }

}  // namespace

std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const Vec3 inside = glm::refract(hit.direction, hit.normal, 1.0 / refractive_index);
  if (is_zero(inside)) return {};
  const double chord = 2.0 * glm::dot(sphere.center - hit.point, inside);
  const Vec3 end = hit.point + chord * inside;
  const Vec3 outward = glm::normalize(end - sphere.center);
  Vec3 outside = glm::refract(inside, -outward, refractive_index);
  if (is_zero(outside)) outside = glm::normalize(inside - glm::dot(inside, outward) * outward);
  return Ray{end + lift * outward, outside, hit.leaves};
}

double schlick(double cos_theta, double refractive_index) {
  const double r = (refractive_index - 1.0) / (refractive_index + 1.0);
  const double x = 1.0 - glm::clamp(cos_theta, 0.0, 1.0);
  const double x2 = x * x;
  return r * r + (1.0 - r * r) * x2 * x2 * x;
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const Vec3 mirrored = glm::reflect(hit.direction, hit.normal);
  const Bounce reflected{{hit.point + lift * hit.normal, mirrored, hit.leaves}, 1.0};
  if (hit.leaves.side == Side::outwards) {
    const std::optional<Ray> through = through_sphere(sphere, refractive_index, hit);
    if (!through) return {reflected, {}};
    const double r = schlick(-glm::dot(hit.direction, hit.normal), refractive_index);
    return {{reflected.ray, r}, {*through, 1.0 - r}};
  }
  const Vec3 out = glm::refract(hit.direction, hit.normal, refractive_index);
  if (is_zero(out)) return {reflected, {}};
  const double r = schlick(-glm::dot(out, hit.normal), refractive_index);
  return {{reflected.ray, r}, {{hit.point - lift * hit.normal, out, {hit.leaves.geometry, Side::outwards}}, 1.0 - r}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
