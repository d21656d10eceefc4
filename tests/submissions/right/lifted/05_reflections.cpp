// Rays start a little off the surface, along its normal, as most textbooks have it.
#include "stages/05_reflections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

constexpr double lift = 1e-4;

Vec3 reflect(const Vec3& d, const Vec3& n) { return d - 2.0 * dot(d, n) * n; }

Bounce mirror_bounce(const Hit& hit, double k_s) {
  return {{hit.point + lift * hit.normal, reflect(hit.direction, hit.normal), hit.leaves}, k_s};
}

bool go_on(int bounce, int max_bounces, double weight) { return bounce <= max_bounces && weight > 0; }

}  // namespace raylab::RAYLAB_IMPLEMENTATION
