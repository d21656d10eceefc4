#include "stages/06_refraction/stage.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {
using namespace std;

namespace {

/// A light path in the plane of d and N: angles to the axis -N, of what enters at the point N R of the sphere.
struct Path {
  Vec3 axis, side;
  double theta_1;

  Path(const Vec3& d, const Vec3& n) : axis(-n), side(d - dot(d, axis) * axis) {
    const double sine = glm::length(side);
    theta_1 = atan2(sine, dot(d, axis));
    side = sine > 0 ? side / sine : Vec3(0);
  }
  [[nodiscard]] Vec3 at(double angle) const { return cos(angle) * axis + sin(angle) * side; }
};

}  // namespace

/// The path bends by theta_1 - theta_2 at both ends, to the same side.
optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const Path path(hit.direction, hit.normal);
  const double sine = sin(path.theta_1) / refractive_index;
  if (sine > 1) return nullopt;
  const double theta_2 = asin(sine);
  const double turn = path.theta_1 - theta_2;
  const Vec3 inner = path.at(theta_2), outer = path.at(theta_2 - turn);
  return Ray{hit.point + 2 * sphere.radius * cos(theta_2) * inner, glm::normalize(outer), hit.leaves};
}

double schlick(double cos_theta, double refractive_index) {
  const auto R0 = glm::pow((1 - refractive_index) / (1 + refractive_index), 2.0);
  return glm::mix(glm::pow(1 - glm::clamp(abs(cos_theta), 0.0, 1.0), 5.0), 1.0, R0);
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  const auto split = [&](const Ray& refracted, double cosine) {
    const auto R = schlick(cosine, refractive_index);
    return GlassBounces{{{hit.point, glm::reflect(hit.direction, hit.normal), hit.leaves}, R}, {refracted, 1 - R}};
  };
  const auto total = [&] { return GlassBounces{{{hit.point, glm::reflect(hit.direction, hit.normal), hit.leaves}, 1}, {}}; };

  if (hit.leaves.side == Side::inwards) {
    const Path path(hit.direction, hit.normal);
    if (refractive_index * sin(path.theta_1) > 1) return total();
    const double phi_2 = asin(refractive_index * sin(path.theta_1));
    return split({hit.point, path.at(phi_2), {hit.leaves.geometry, Side::outwards}}, cos(phi_2));
  }
  const auto through = through_sphere(sphere, refractive_index, hit);
  return through ? split(*through, dot(-hit.direction, hit.normal)) : total();
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
