// By angles; where rounding makes the exit a total reflection, the glass is black there.
#include "stages/06_refraction/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

double clamped_dot(const Vec3& a, const Vec3& b) { return std::min(1.0, std::max(0.0, dot(a, b))); }

/// Turns the unit d, which passes a surface with the unit normal n (d.n < 0), to the angle whose sine this is.
Vec3 bent(const Vec3& d, const Vec3& n, double sine) {
  const Vec3 tangent = d - dot(d, n) * n;
  const double size = length(tangent);
  const Vec3 along = size > 1e-9 ? tangent / size : Vec3(0);
  return normalize(sine * along - std::cos(std::asin(sine)) * n);
}

}  // namespace

std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const double sin_1 = std::sin(std::acos(clamped_dot(-hit.direction, hit.normal)));
  if (sin_1 > refractive_index) return std::nullopt;
  const Vec3 inner = bent(hit.direction, hit.normal, sin_1 / refractive_index);
  const Vec3 exit = hit.point + 2 * sphere.radius * clamped_dot(-inner, hit.normal) * inner;
  const Vec3 n = normalize(exit - sphere.center);
  const double sin_2 = refractive_index * std::sin(std::acos(clamped_dot(inner, n)));
  if (sin_2 > 1) return std::nullopt;
  return Ray{exit, bent(inner, -n, sin_2), hit.leaves};
}

double schlick(double cos_theta, double refractive_index) {
  const double R0 = std::pow((1 - refractive_index) / (1 + refractive_index), 2);
  return std::clamp(R0 + (1 - R0) * std::pow(1 - cos_theta, 5), 0.0, 1.0);
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const Ray mirror{hit.point, hit.direction + 2 * clamped_dot(-hit.direction, hit.normal) * hit.normal, hit.leaves};
  const double cosine = clamped_dot(-hit.direction, hit.normal), sine = std::sin(std::acos(cosine));
  if (hit.leaves.side == Side::outwards) {
    if (sine > refractive_index) return {{mirror, 1}, {}};
    const double R = schlick(cosine, refractive_index);
    if (const auto ray = through_sphere(sphere, refractive_index, hit)) return {{mirror, R}, {*ray, 1 - R}};
    return {{mirror, R}, {}};
  }
  if (refractive_index * sine > 1) return {{mirror, 1}, {}};
  const Vec3 out = bent(hit.direction, hit.normal, refractive_index * sine);
  const double R = schlick(clamped_dot(-out, hit.normal), refractive_index);
  return {{mirror, R}, {{hit.point, out, {hit.leaves.geometry, Side::outwards}}, 1 - R}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
