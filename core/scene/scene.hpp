#pragma once

#include "core/math/camera.hpp"
#include "core/math/fields.hpp"
#include "core/math/lights.hpp"
#include "core/math/material.hpp"
#include "core/math/ray.hpp"
#include "core/math/shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace raylab {

/// The size of an image in pixels, each 1 to 65536.
struct ImageSize {
  int width = 640;
  int height = 480;
};
RAYLAB_FIELDS(ImageSize, RAYLAB_FIELD(width) RAYLAB_FIELD(height))

/// The size of the same shape whose longer side has `side` pixels.
inline ImageSize fitted(ImageSize size, int side) {
  const int longer = std::max(size.width, size.height);
  const auto scaled = [&](int pixels) { return std::max(1, (pixels * side + longer / 2) / longer); };
  return {scaled(size.width), scaled(size.height)};
}

struct PlaneObject {
  Plane shape;
  Material material;
};
RAYLAB_FIELDS(PlaneObject, RAYLAB_FIELD(shape) RAYLAB_FIELD(material))

struct SphereObject {
  Sphere shape;
  Material material;
};
RAYLAB_FIELDS(SphereObject, RAYLAB_FIELD(shape) RAYLAB_FIELD(material))

/// Many opaque spheres that share one material; with a table of colors each has its own instead of `material.color`.
struct SphereCloud {
  std::vector<Sphere> spheres;
  std::vector<Color> colors;  ///< empty, or one for each sphere
  Material material;
};
RAYLAB_FIELDS(SphereCloud, RAYLAB_FIELD(spheres) RAYLAB_FIELD(colors) RAYLAB_FIELD(material))

/// All that a scene file says, as plain data: one array for each kind of thing, in file order. Numbers are as written:
/// directions are not yet unit vectors.
struct Scene {
  std::string title;
  int max_bounces = 5;  ///< 0 to 100; the primary ray is bounce 0
  Color background;
  Camera camera;
  ImageSize image;
  std::vector<PlaneObject> planes;
  std::vector<SphereObject> spheres;
  std::vector<SphereCloud> clouds;
  std::vector<PointLight> point_lights;
  std::vector<DirectionalLight> directional_lights;
  std::vector<AmbientLight> ambient_lights;
};
RAYLAB_FIELDS(Scene, RAYLAB_FIELD(title) RAYLAB_FIELD(max_bounces) RAYLAB_FIELD(background) RAYLAB_FIELD(camera)
                         RAYLAB_FIELD(image) RAYLAB_FIELD(planes) RAYLAB_FIELD(spheres) RAYLAB_FIELD(clouds)
                             RAYLAB_FIELD(point_lights) RAYLAB_FIELD(directional_lights) RAYLAB_FIELD(ambient_lights))

/// How many geometries there are: GeometryIds run from 0 to one less.
inline std::size_t geometry_count(const Scene& scene) {
  std::size_t count = scene.planes.size() + scene.spheres.size();
  for (const SphereCloud& cloud : scene.clouds) count += cloud.spheres.size();
  return count;
}

}  // namespace raylab
