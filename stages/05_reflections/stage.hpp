#pragma once

#include "core/math/contract.hpp"
#include "core/math/hit.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 5.1: the mirror image of direction `d` at a surface with unit normal `n`.
/// d, n: unit vectors, d.n <= 0: `d` is the way the ray travels. Returns a unit vector. Handout section 5, equation 4.
Vec3 reflect(const Vec3& d, const Vec3& n);

/// Task 5.2: the ray that a shiny surface sends on, and the weight of the color at its end.
/// k_s: the specular weight of the surface's shininess, from task 3.1.
/// The ray starts at `hit.point` and leaves what `hit.leaves` says. The weight is k_s. Handout section 5.
Bounce mirror_bounce(const Hit& hit, double k_s);

/// Task 5.3: is a bounced ray traced at all?
/// bounce: its number; the camera's ray is bounce 0, so its reflection is bounce 1. max_bounces: the last number that is
/// still traced, >= 0. weight: of the color it would bring; a ray of weight 0 is not traced. Handout section 5.
bool go_on(int bounce, int max_bounces, double weight);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_05_REFLECTIONS(TASK)                                                             \
  TASK("5.1", reflect, "the mirror image of a direction", R"({"d": [0.6, -0.8, 0], "n": [0, 1, 0]})") \
  TASK("5.2", mirror_bounce, "the ray that a shiny surface sends on",                                 \
       R"({"hit": {"point": [0, 0, 0], "direction": [0.6, -0.8, 0], "normal": [0, 1, 0], )"           \
       R"("leaves": {"geometry": 0}}, "k_s": 0.5})")                                                  \
  TASK("5.3", go_on, "is a bounced ray traced?", R"({"bounce": 1, "max_bounces": 5, "weight": 0.5})")
