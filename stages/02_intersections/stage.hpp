#pragma once

#include "core/math/contract.hpp"
#include "core/math/hit.hpp"
#include "core/math/ray.hpp"
#include "core/math/shapes.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 2.1: the distance t >= 0 at which `ray` meets `plane`; nothing if it misses.
/// A ray that is parallel to the plane, or lies in it, misses. The ray does not leave this plane.
/// Handout section 3.1, equation 1, with the segment's far end at infinity.
std::optional<double> plane_hit(const Ray& ray, const Plane& plane);

/// Task 2.2: the least distance t >= 0 at which `ray` meets `sphere`; nothing if it misses.
/// A ray that touches the sphere hits it; one that starts inside hits the far side. The ray does not leave this sphere.
/// Handout section 3.2, equation 2, with the segment's far end at infinity.
std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere);

/// Task 2.3: the unit normal of `sphere` at `point`, which lies on it: outwards, whoever looks. Handout section 3.2.
Vec3 sphere_normal(const Sphere& sphere, const Vec3& point);

/// Task 2.4: the place in `candidates`, from 0, of the nearest hit; nothing if all are misses.
/// Of equal distances the first in the list wins. Handout section 3.3.
std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_02_INTERSECTIONS(TASK)                                                                              \
  TASK("2.1", plane_hit, "where a ray meets a plane",                                                                    \
       R"({"ray": {"origin": [0, 3, 0], "direction": [0, -1, 0]}, "plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}})") \
  TASK("2.2", sphere_hit, "where a ray meets a sphere",                                                                  \
       R"({"ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}, "sphere": {"center": [0, 0, 0], "radius": 1}})")       \
  TASK("2.3", sphere_normal, "the direction away from a sphere",                                                         \
       R"({"sphere": {"center": [0, 0, 0], "radius": 2}, "point": [0, 2, 0]})")                                          \
  TASK("2.4", nearest_hit, "the nearest of what a ray meets", R"({"candidates": [{"t": 3}, {"t": null}, {"t": 1.5}]})")
