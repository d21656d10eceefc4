#pragma once

#include "core/math/contract.hpp"
#include "core/math/seen.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 8.1: what is left of a color after its way through the haze.
/// seen: what was seen along a ray. At distance t the part e^(-t/20) of its color is left, and the rest is the background's.
/// A ray that met nothing shows the background as it is.
Color depth_cue(const Seen& seen);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_08_DEPTH_CUEING(TASK)                                   \
  TASK("8.1", depth_cue, "what haze leaves of a color",                      \
       R"({"seen": {"color": [1, 0, 0], "t": 20, "background": [0, 0, 1], )" \
       R"("ray": {"origin": [0, 0, 0], "direction": [0, 0, -1]}}})")
