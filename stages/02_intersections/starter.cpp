// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/02_intersections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 2.1: where a ray meets a plane.
std::optional<double> plane_hit(const Ray& ray, const Plane& plane) {
  RAYLAB_NOT_WRITTEN("2.1");
}

// Task 2.2: where a ray meets a sphere.
std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
  RAYLAB_NOT_WRITTEN("2.2");
}

// Task 2.3: the direction away from a sphere.
Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) {
  RAYLAB_NOT_WRITTEN("2.3");
}

// Task 2.4: the nearest of what a ray meets.
std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
  RAYLAB_NOT_WRITTEN("2.4");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
