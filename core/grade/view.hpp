#pragma once

#include "core/image/reference.hpp"
#include "core/math/camera.hpp"
#include "core/scene/scene.hpp"

#include <cstdint>
#include <random>
#include <string>

namespace raylab {

/// An image that submissions are asked for.
struct View {
  int stage = 0;
  std::string name;     ///< the scene's: "scene3"
  bool hidden = false;  ///< from a drawn camera
  Scene scene;
  Reference reference;
};

/// A camera that sees the same things as the scene's own, from somewhere else: moved by up to a fifth of its distance to the
/// spheres' middle, turned by up to 8 degrees in each direction, and with a field of view up to a seventh wider or narrower.
/// The same numbers from `random` give the same camera everywhere.
Camera drawn_camera(const Scene& scene, std::mt19937_64& random);

}  // namespace raylab
