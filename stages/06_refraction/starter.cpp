// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/06_refraction/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 6.1: the ray that has passed through glass.
std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
  RAYLAB_NOT_WRITTEN("6.1");
}

// Task 6.2: how much glass reflects.
double schlick(double cos_theta, double refractive_index) {
  RAYLAB_NOT_WRITTEN("6.2");
}

// Task 6.3: the two rays that glass sends on.
GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
  RAYLAB_NOT_WRITTEN("6.3");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
