#include "stages/06_refraction/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

struct FloatRay {
  glm::vec3 origin, direction;
};

/// Snell's law for a unit d that meets a unit n with d.n < 0; eta is the ratio of the indices, from over to.
std::optional<glm::vec3> refract(const glm::vec3& d, const glm::vec3& n, float eta) {
  const float cosine = -glm::dot(d, n);
  const float k = 1.0f - eta * eta * (1.0f - cosine * cosine);
  if (k < 0.0f) return std::nullopt;
  return glm::normalize(eta * d + (eta * cosine - std::sqrt(k)) * n);
}

float fresnel(float cosine, float n) {
  const float r0 = (1.0f - n) * (1.0f - n) / ((1.0f + n) * (1.0f + n));
  const float x = 1.0f - std::clamp(cosine, 0.0f, 1.0f);
  return r0 + (1.0f - r0) * x * x * x * x * x;
}

std::optional<FloatRay> pass(const Sphere& sphere, float n, const Hit& hit) {
  const glm::vec3 center(sphere.center), point(hit.point), d(hit.direction), normal(hit.normal);
  const std::optional<glm::vec3> inner = refract(d, normal, 1.0f / n);
  if (!inner) return std::nullopt;
  const glm::vec3 exit = point - 2.0f * glm::dot(point - center, *inner) * *inner;
  const glm::vec3 inward = glm::normalize(center - exit);
  // Inside a sphere both angles are the same; only rounding can say that nothing gets out, and then it leaves as it came.
  const std::optional<glm::vec3> outer = refract(*inner, inward, n);
  if (outer) return FloatRay{exit, *outer};
  const glm::vec3 grazing = glm::normalize(*inner - glm::dot(*inner, inward) * inward);
  const float cosine = std::clamp(-glm::dot(d, normal), 0.0f, 1.0f);
  return FloatRay{exit, glm::normalize(std::sqrt(1.0f - cosine * cosine) * grazing - cosine * inward)};
}

}  // namespace

std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const std::optional<FloatRay> ray = pass(sphere, static_cast<float>(refractive_index), hit);
  if (!ray) return std::nullopt;
  return Ray{Vec3(ray->origin), Vec3(ray->direction), hit.leaves};
}

double schlick(double cos_theta, double refractive_index) {
  return static_cast<double>(fresnel(static_cast<float>(cos_theta), static_cast<float>(refractive_index)));
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const glm::vec3 d(hit.direction), normal(hit.normal);
  const auto n = static_cast<float>(refractive_index);
  const glm::vec3 mirrored = glm::normalize(glm::reflect(d, normal));
  const Ray reflected{Vec3(glm::vec3(hit.point)), Vec3(mirrored), hit.leaves};

  float cosine = -glm::dot(d, normal);
  std::optional<Ray> refracted;
  if (hit.leaves.side == Side::outwards) {
    refracted = through_sphere(sphere, refractive_index, hit);
  } else if (const std::optional<glm::vec3> out = refract(d, normal, n)) {
    refracted = Ray{Vec3(glm::vec3(hit.point)), Vec3(*out), {hit.leaves.geometry, Side::outwards}};
    cosine = -glm::dot(*out, normal);
  }
  if (!refracted) return {{reflected, 1}, {}};
  const float R = fresnel(cosine, n);
  return {{reflected, static_cast<double>(R)}, {*refracted, static_cast<double>(1.0f - R)}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
