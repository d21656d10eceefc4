#include "stages/05_reflections/stage.hpp"

#include <glm/glm.hpp>

namespace raylab::RAYLAB_IMPLEMENTATION {

Vec3 reflect(const Vec3& d, const Vec3& n) {
  // The matrix of Householder.
  const auto mirror = glm::dmat3(1.0) - 2.0 * glm::outerProduct(n, n);
  return mirror * d;
}

Bounce mirror_bounce(const Hit& hit, double k_s) {
  Bounce bounce;
  bounce.weight = k_s;
  bounce.ray = Ray{.origin = hit.point, .direction = glm::reflect(hit.direction, hit.normal), .leaves = hit.leaves};
  return bounce;
}

bool go_on(int bounce, int max_bounces, double weight) {
  const auto used_up = bounce > max_bounces;
  const auto black = weight == 0.0;
  return !used_up && !black;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
