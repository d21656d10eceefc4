#include "stages/06_refraction/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {
namespace {

/// The mirrored ray on the viewer's side. (Stage 5 has the same formula; each stage's file stands alone.)
Ray reflected(const Hit& hit) {
  return {hit.point, hit.direction - 2 * dot(hit.direction, hit.normal) * hit.normal, hit.leaves};
}

}  // namespace

// Task 6.1: the ray that has passed through glass.
std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  // Snell's law needs no angles. Split the unit direction d at the surface into its parts along N and across it: across,
  // refraction divides by n; along, the part follows from the length 1. So the inner direction is T = (d - g N) / n with
  //   n cos(theta_2) = sqrt(n^2 - sin^2(theta_1)) = q   and   g = q - cos(theta_1).
  // asin and sin would lose half the digits near grazing, and could see a total reflection that is not there.
  const Vec3& d = hit.direction;
  const Vec3& N1 = hit.normal;
  const double n = refractive_index;
  const double cos_1 = std::max(0.0, -dot(d, N1));

  const double q_squared = (n - 1) * (n + 1) + cos_1 * cos_1;  // n^2 - sin^2(theta_1), without its cancellation
  if (q_squared < 0) return {};                                // nothing enters
  const double q = std::sqrt(q_squared);
  const double cos_2 = q / n;
  const double g = q + cos_1 > 0 ? (n - 1) * (n + 1) / (q + cos_1) : 0;  // q - cos_1, again without cancellation
  const Vec3 T = (d - g * N1) / n;

  // Inside, the ray cuts the sphere at equal angles at both ends (phi_1 = theta_2), along a chord of 2 R cos(theta_2). That
  // gives the second normal; and the second refraction undoes the first, mirrored (phi_2 = theta_1).
  const Vec3 N2 = N1 + 2 * cos_2 * T;
  const Vec3 exit = d - 2 * g * (N1 + cos_2 * T);
  return Ray{sphere.center + sphere.radius * N2, exit, hit.leaves};
}

// Task 6.2: how much glass reflects.
double schlick(double cos_theta, double refractive_index) {
  const double n = refractive_index;
  const double root_R0 = (1 - n) / (1 + n);
  const double R0 = root_R0 * root_R0;
  const double m = 1 - std::clamp(cos_theta, 0.0, 1.0);
  return R0 + (1 - R0) * (m * m * m * m * m);
}

namespace {

GlassBounces from_outside(const Sphere& sphere, double n, const Hit& hit) {
  const std::optional<Ray> exit = through_sphere(sphere, n, hit);
  if (!exit) return {{reflected(hit), 1}, {}};
  const double R = schlick(-dot(hit.direction, hit.normal), n);
  return {{reflected(hit), R}, {*exit, 1 - R}};
}

GlassBounces from_inside(double n, const Hit& hit) {
  // Snell's law the other way round: across the normal the direction is multiplied by n.
  const double cos_phi_1 = -dot(hit.direction, hit.normal);
  const double cos_squared = n * n * cos_phi_1 * cos_phi_1 - (n - 1) * (n + 1);  // 1 - n^2 sin^2(phi_1)
  if (cos_squared < 0) return {{reflected(hit), 1}, {}};
  const double cos_phi_2 = std::sqrt(cos_squared);  // in air
  const Vec3 out = n * hit.direction + (n * cos_phi_1 - cos_phi_2) * hit.normal;
  const double R = schlick(cos_phi_2, n);
  return {{reflected(hit), R}, {{hit.point, out, {hit.leaves.geometry, Side::outwards}}, 1 - R}};
}

}  // namespace

// Task 6.3: the two rays that glass sends on.
GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  return hit.leaves.side == Side::outwards ? from_outside(sphere, refractive_index, hit)
                                           : from_inside(refractive_index, hit);
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
