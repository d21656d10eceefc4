#pragma once

#include "core/math/contract.hpp"
#include "core/math/hit.hpp"

#include <span>

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 4.1: is the light kept from the shaded point?
/// crossings: every surface that the ray from the point towards the light meets, in no particular order, each with its
/// distance t >= 0 from the point; the point's own surface is not among them, unless it is met again from inside.
/// distance: to the light; infinity for a directional light.
/// Only what is opaque and nearer than the light blocks it. Handout section 4.2.
bool blocked(std::span<const Crossing> crossings, double distance);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_04_SHADOWS(TASK)                     \
  TASK("4.1", blocked, "is the light kept from a point?", \
       R"({"crossings": [{"t": 2, "transparent": true}, {"t": 5}], "distance": "inf"})")
