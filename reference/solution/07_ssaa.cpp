#include "stages/07_ssaa/stage.hpp"

#include <algorithm>

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 7.1: where a pixel's samples lie.
std::vector<SampleOffset> sample_positions() {
  return {{+1. / 8, +3. / 8}, {+3. / 8, -1. / 8}, {-1. / 8, -3. / 8}, {-3. / 8, +1. / 8}};
}

// Task 7.2: from samples to the pixel's color.
Color resolve(std::span<const Color> samples) {
  Color sum(0);
  for (const Color& sample : samples) sum += sample;
  const Color mean = sum / static_cast<double>(samples.size());
  // std::clamp, unlike a chain of min and max, leaves a NaN as it is.
  return {std::clamp(mean.r, 0.0, 1.0), std::clamp(mean.g, 0.0, 1.0), std::clamp(mean.b, 0.0, 1.0)};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
