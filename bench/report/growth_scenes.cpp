#include "bench/report/growth_scenes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

namespace raylab::bench {
namespace {

constexpr double perfect_mirror = std::numeric_limits<double>::infinity();

Scene with_camera() {
  Scene scene;
  scene.background = {0.6, 0.7, 0.8};
  scene.camera.position = {0, 1.2, 6};
  scene.camera.facing = {0, -0.1, -1};
  scene.camera.half_field_of_view = 35;
  return scene;
}

constexpr std::array<Sphere, 5> places{{{{-2.2, 0.9, -0.5}, 0.9},
                                        {{0, 1.1, -1.2}, 1.1},
                                        {{2.2, 0.8, -0.2}, 0.8},
                                        {{-0.9, 0.45, 1.4}, 0.45},
                                        {{1.1, 0.4, 1.6}, 0.4}}};

}  // namespace

Scene many_spheres(std::size_t count) {
  Scene scene = with_camera();
  scene.camera.position = {0.5, 0.5, 2.2};
  scene.camera.facing = {0, 0, -1};
  scene.camera.half_field_of_view = 20;
  scene.point_lights.push_back({{2, 3, 4}, 30});
  SphereCloud cloud;
  cloud.material.color = {0.8, 0.5, 0.3};
  std::mt19937_64 random(1);
  const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double radius = 0.3 / std::cbrt(static_cast<double>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const double x = next(), y = next(), z = next();
    cloud.spheres.push_back({{x, y, z}, radius});
  }
  scene.clouds.push_back(std::move(cloud));
  return scene;
}

Scene five_spheres(const Features& features) {
  Scene scene = with_camera();
  for (const Sphere& place : places) scene.spheres.push_back({place, {.color = {0.8, 0.5, 0.3}}});
  // A shiny sphere has both a highlight and a mirror image. With no bounces there is only the highlight.
  if (features.highlights || features.mirror) scene.spheres[0].material.shininess = 100;
  scene.max_bounces = features.mirror || features.glass ? 5 : 0;
  if (features.glass) scene.spheres[1].material.transparent = true;
  if (features.plane) scene.planes.push_back({{{0, 0, 0}, {0, 1, 0}}, {.color = Color(0.6)}});
  scene.point_lights.push_back({{-3, 6, 5}, 60});
  if (features.directional_light) scene.directional_lights.push_back({{-1, -2, -1}, 0.3});
  return scene;
}

Scene many_lights(int count) {
  Scene scene = five_spheres({.plane = true});
  scene.point_lights.clear();
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    scene.point_lights.push_back({{4 * std::cos(angle), 5, 4 * std::sin(angle)}, 60.0 / count});
  }
  return scene;
}

Scene mirrors() {
  Scene scene = five_spheres();
  for (SphereObject& sphere : scene.spheres) sphere.material.shininess = perfect_mirror;
  const Material mirror{.color = Color(0.5), .shininess = perfect_mirror};
  scene.planes.push_back({{{0, 0, -4}, {0, 0, 1}}, mirror});
  scene.planes.push_back({{{0, 0, 7}, {0, 0, -1}}, mirror});
  return scene;
}

}  // namespace raylab::bench
