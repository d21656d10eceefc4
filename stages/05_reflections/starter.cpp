// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/05_reflections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 5.1: the mirror image of a direction.
Vec3 reflect(const Vec3& d, const Vec3& n) {
  RAYLAB_NOT_WRITTEN("5.1");
}

// Task 5.2: the ray that a shiny surface sends on.
Bounce mirror_bounce(const Hit& hit, double k_s) {
  RAYLAB_NOT_WRITTEN("5.2");
}

// Task 5.3: is a bounced ray traced?
bool go_on(int bounce, int max_bounces, double weight) {
  RAYLAB_NOT_WRITTEN("5.3");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
