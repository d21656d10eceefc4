// Your work for this stage. What each task takes and returns is in stage.hpp, how to think about it in README.md.
// Replace the line RAYLAB_NOT_WRITTEN of a task by your code.

#include "stages/03_blinn_phong/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 3.1: how much a shiny surface mirrors.
double specular_weight(double shininess) {
  RAYLAB_NOT_WRITTEN("3.1");
}

// Task 3.2: diffuse and specular light from one direction.
Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  RAYLAB_NOT_WRITTEN("3.2");
}

// Task 3.3: a point light's part.
Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  RAYLAB_NOT_WRITTEN("3.3");
}

// Task 3.4: a directional light's part.
Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  RAYLAB_NOT_WRITTEN("3.4");
}

// Task 3.5: an ambient light's part.
Color ambient_light(const AmbientLight& light, const Material& material) {
  RAYLAB_NOT_WRITTEN("3.5");
}

// Task 3.6: all lights together.
Color sum_lights(std::span<const Color> contributions) {
  RAYLAB_NOT_WRITTEN("3.6");
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
