#include "stages/05_reflections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

Vec3 reflect(const Vec3& d, const Vec3& n) { return glm::reflect(d, n); }

Bounce mirror_bounce(const Hit& hit, double k_s) {
  constexpr double shift = 0.001;
  const Vec3 direction = reflect(hit.direction, hit.normal);
  return {{hit.point + shift * direction, direction, hit.leaves}, k_s};
}

bool go_on(int bounce, int max_bounces, double weight) { return weight > 0 && !(bounce > max_bounces); }

}  // namespace raylab::RAYLAB_IMPLEMENTATION
