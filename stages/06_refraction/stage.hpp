#pragma once

#include "core/math/contract.hpp"
#include "core/math/hit.hpp"
#include "core/math/shapes.hpp"

#include <optional>

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 6.1: the ray that has passed through a glass sphere met from outside; nothing if no light enters.
/// hit: where the ray meets `sphere`; its normal points outwards. refractive_index: n, 0.1 to 10, air around it.
/// Returns the ray after both refractions: it starts at the second point of the same sphere, with a unit direction, and
/// leaves what `hit.leaves` says, the sphere outwards. Whatever else is inside the sphere is passed by (D15).
/// Nothing where sin(theta_1) > n, which takes n < 1: total reflection (D16). Handout section 6.1, equation 5.
std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit);

/// Task 6.2: R, the part of the light that glass reflects: Schlick's approximation.
/// cos_theta: between the view vector and the normal, in air; rounding may have brought it a little outside 0 to 1.
/// refractive_index: n > 0. Returns 0 to 1. Handout section 6.2, equation 6.
double schlick(double cos_theta, double refractive_index);

/// Task 6.3: the two rays that glass sends on, with the weights R and 1 - R. Handout sections 6.1 and 6.2, equation 7.
/// From outside (`hit.leaves.side` is outwards) they are the reflected ray and the ray through the sphere of task 6.1.
/// From inside they are the ray reflected inwards, which leaves what `hit.leaves` says, and the ray refracted out, which
/// leaves the same geometry outwards; R takes the cosine on the air side (D17).
/// Total reflection: the reflected ray has weight 1 and the refracted one weight 0.
GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_06_REFRACTION(TASK)                                                                                   \
  TASK("6.1", through_sphere, "the ray that has passed through glass",                                                     \
       R"({"sphere": {"center": [0, 0, 0], "radius": 1}, "refractive_index": 1.5, )"                                       \
       R"("hit": {"point": [0, 0.6, 0.8], "direction": [0, 0, -1], "normal": [0, 0.6, 0.8], "leaves": {"geometry": 0}}})") \
  TASK("6.2", schlick, "how much glass reflects", R"({"cos_theta": 0.5, "refractive_index": 1.5})")                        \
  TASK("6.3", glass_bounces, "the two rays that glass sends on",                                                           \
       R"({"sphere": {"center": [0, 0, 0], "radius": 1}, "refractive_index": 1.5, )"                                       \
       R"("hit": {"point": [0, 0.6, 0.8], "direction": [0, 0, -1], "normal": [0, 0.6, 0.8], "leaves": {"geometry": 0}}})")
