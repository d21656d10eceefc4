#include "stages/01_rays/stage.hpp"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {
namespace {

/// a b - c d, right to an ulp or two however nearly the products cancel (Kahan): fma() finds what the rounding of c d lost.
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double lost = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + lost;
}

/// a x b. The plain formula would turn the picture where facing and up are nearly parallel.
Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// tan(theta) of degrees. Near 90 the tangent is as large as what is missing to that is small, and radians have rounded it
/// away: 90 - theta is exact.
double tan_of_degrees(double theta) {
  return theta <= 45 ? std::tan(glm::radians(theta)) : 1 / std::tan(glm::radians(90 - theta));
}

}  // namespace

// Task 1.1: the ray through a pixel.
Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  const Vec3 f = unit(camera.facing);
  const Vec3 r = unit(accurate_cross(scaled(camera.facing), scaled(camera.up)));
  const Vec3 u = cross(r, f);  // the camera's own up vector need not stand at a right angle to f

  const double s = 2 * tan_of_degrees(camera.half_field_of_view) / std::max(width, height);

  const Vec3 direction = f + (x - 0.5 + dx) * s * r + (y - 0.5 + dy) * s * u;
  return {camera.position, unit(direction), {}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
