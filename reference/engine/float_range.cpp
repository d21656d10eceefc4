#include "reference/engine/prepared.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace raylab::fast {
namespace {

constexpr double largest = 1e15;
constexpr double smallest_radius = 1e-15;

[[noreturn]] void refuse(const std::string& what, double value, const char* limit) {
  std::ostringstream message;
  message << what << ": " << value << " is " << limit << ", the limit of a render in float; use --precision f64";
  throw std::invalid_argument(message.str());
}

/// `object` and `field` are put together only for the message: a cloud may have a million spheres.
struct Name {
  const char* kind;
  std::size_t index;
  const char* field;

  std::string text() const { return std::string(kind) + "[" + std::to_string(index) + "]." + field; }
};

void check(const Name& name, double value) {
  if (std::abs(value) > largest) refuse(name.text(), value, "beyond 1e15");
}

void check(const Name& name, const raylab::Vec3& value) {
  for (const double component : {value.x, value.y, value.z}) check(name, component);
}

void check_radius(const Name& name, double radius) {
  check(name, radius);
  if (radius < smallest_radius) refuse(name.text(), radius, "below 1e-15");
}

void check_material(const char* kind, std::size_t i, const Material& material) {
  check({kind, i, "color"}, material.color);
  if (!std::isinf(material.shininess)) check({kind, i, "shininess"}, material.shininess);
}

void check_cloud(std::size_t i, const SphereCloud& cloud) {
  check_material("sphere_cloud", i, cloud.material);
  for (const Sphere& sphere : cloud.spheres) {
    check({"sphere_cloud", i, "center"}, sphere.center);
    check_radius({"sphere_cloud", i, "radius"}, sphere.radius);
  }
  for (const Color& color : cloud.colors) check({"sphere_cloud", i, "color"}, color);
}

void check_lights(const Scene& scene) {
  for (std::size_t i = 0; i < scene.point_lights.size(); ++i) {
    check({"point_light", i, "position"}, scene.point_lights[i].position);
    check({"point_light", i, "intensity"}, scene.point_lights[i].intensity);
  }
  for (std::size_t i = 0; i < scene.directional_lights.size(); ++i)
    check({"directional_light", i, "intensity"}, scene.directional_lights[i].intensity);
  for (std::size_t i = 0; i < scene.ambient_lights.size(); ++i)
    check({"ambient_light", i, "intensity"}, scene.ambient_lights[i].intensity);
}

void check_single(const char* name, const raylab::Vec3& value) {
  for (const double component : {value.x, value.y, value.z})
    if (std::abs(component) > largest) refuse(name, component, "beyond 1e15");
}

}  // namespace

void check_float_range(const Scene& scene) {
  check_single("background", scene.background);
  check_single("camera.position", scene.camera.position);
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    check({"plane", i, "point"}, scene.planes[i].shape.point);
    check_material("plane", i, scene.planes[i].material);
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    check({"sphere", i, "center"}, scene.spheres[i].shape.center);
    check_radius({"sphere", i, "radius"}, scene.spheres[i].shape.radius);
    check_material("sphere", i, scene.spheres[i].material);
  }
  for (std::size_t i = 0; i < scene.clouds.size(); ++i) check_cloud(i, scene.clouds[i]);
  check_lights(scene);
}

}  // namespace raylab::fast
