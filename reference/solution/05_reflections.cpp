#include "stages/05_reflections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 5.1: the mirror image of a direction.
Vec3 reflect(const Vec3& d, const Vec3& n) {
  // Equation 4 speaks of r, the way back to the viewer: r' = r + 2 ((r.n) n - r). With r = -d that is this.
  return d - 2 * dot(d, n) * n;
}

// Task 5.2: the ray that a shiny surface sends on.
Bounce mirror_bounce(const Hit& hit, double k_s) {
  return {{hit.point, reflect(hit.direction, hit.normal), hit.leaves}, k_s};
}

// Task 5.3: is a bounced ray traced?
bool go_on(int bounce, int max_bounces, double weight) { return bounce <= max_bounces && weight != 0; }

}  // namespace raylab::RAYLAB_IMPLEMENTATION
