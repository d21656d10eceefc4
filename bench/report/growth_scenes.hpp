#pragma once

#include "core/scene/scene.hpp"

#include <cstddef>

namespace raylab::bench {

/// `count` matte spheres at random places of a cube, the same ones on every machine, so small that they fill the same part
/// of it whatever their number: a light, and no floor.
Scene many_spheres(std::size_t count);

/// Five matte spheres, a mirroring one and one of glass among them if asked for, under one point light.
struct Features {
  bool plane = false, glass = false, mirror = false, highlights = false, directional_light = false;
};
Scene five_spheres(const Features& features = {});

/// The five spheres on a plane, under this many point lights in a circle.
Scene many_lights(int count);

/// Five perfect mirrors between two mirroring planes: each ray bounces until it may no more.
Scene mirrors();

}  // namespace raylab::bench
