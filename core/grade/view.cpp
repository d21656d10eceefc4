#include "core/grade/view.hpp"

#include "core/math/vec3.hpp"

#include <cmath>
#include <numbers>

namespace raylab {
namespace {

constexpr double most_move = 0.2;
constexpr double most_turn = 8 * std::numbers::pi / 180;
constexpr double most_zoom = 1. / 7;
constexpr double usual_distance = 10;  // where there are no spheres

/// From -1 to 1. (The standard library's distributions differ from one to the next.)
double drawn(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; }

double distance_to_spheres(const Scene& scene) {
  if (scene.spheres.empty()) return usual_distance;
  Vec3 sum(0);
  for (const SphereObject& sphere : scene.spheres) sum += sphere.shape.center;
  return length(sum / static_cast<double>(scene.spheres.size()) - scene.camera.position);
}

}  // namespace

Camera drawn_camera(const Scene& scene, std::mt19937_64& random) {
  Camera camera = scene.camera;
  const Vec3 facing = unit(camera.facing), right = unit(cross(facing, camera.up)), up = cross(right, facing);
  const double reach = most_move * distance_to_spheres(scene);
  const double aside = drawn(random), above = drawn(random), ahead = drawn(random);
  camera.position += reach * (aside * right + above * up + ahead * facing);
  // Towards where it came from, so that what was in sight stays in sight.
  const double pan = most_turn * drawn(random) - most_move * aside, tilt = most_turn * drawn(random) - most_move * above;
  camera.facing = facing + std::tan(pan) * right + std::tan(tilt) * up;
  camera.up = up + std::tan(most_turn * drawn(random)) * right;
  camera.half_field_of_view *= 1 + most_zoom * drawn(random);
  return camera;
}

}  // namespace raylab
