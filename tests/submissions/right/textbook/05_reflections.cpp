#include "stages/05_reflections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Equation 4, for the way back to where the ray came from: r' = r + 2 (proj_n(r) - r).
Vec3 reflect(const Vec3& d, const Vec3& n) {
  const Vec3 r = -d;
  const Vec3 projection = glm::dot(r, n) / glm::dot(n, n) * n;
  return r + 2.0 * (projection - r);
}

Bounce mirror_bounce(const Hit& hit, double k_s) {
  Ray ray;
  ray.origin = hit.point;
  ray.direction = glm::normalize(reflect(hit.direction, hit.normal));
  ray.leaves = hit.leaves;
  return Bounce{ray, k_s};
}

bool go_on(int bounce, int max_bounces, double weight) {
  if (bounce > max_bounces) return false;
  return weight > 0.0;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
