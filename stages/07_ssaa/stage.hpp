#pragma once

#include "core/math/contract.hpp"
#include "core/math/sample.hpp"
#include "core/math/vec3.hpp"

#include <span>
#include <vector>

namespace raylab::RAYLAB_IMPLEMENTATION {

/// Task 7.1: where in a pixel its samples lie: the four places of the rotated grid, in the handout's order.
/// In pixels from the centre, y up. Handout section 2.1, figure 4.
std::vector<SampleOffset> sample_positions();

/// Task 7.2: the pixel's final color: the mean of its samples, clamped once to 0..1 in each component.
/// samples: at least one, not clamped. A component that is not a number must stay so: it is reported, never hidden.
/// Handout sections 2.1 and 8.
Color resolve(std::span<const Color> samples);

}  // namespace raylab::RAYLAB_IMPLEMENTATION

#define RAYLAB_TASKS_07_SSAA(TASK)                                      \
  TASK("7.1", sample_positions, "where a pixel's samples lie", R"({})") \
  TASK("7.2", resolve, "from samples to the pixel's color", R"({"samples": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]})")
