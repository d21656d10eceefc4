#include "stages/07_ssaa/stage.hpp"

#include <algorithm>

namespace raylab::RAYLAB_IMPLEMENTATION {

std::vector<SampleOffset> sample_positions() {
  std::vector<SampleOffset> result;
  result.push_back({0.125, 0.375});
  result.push_back({0.375, -0.125});
  result.push_back({-0.125, -0.375});
  result.push_back({-0.375, 0.125});
  return result;
}

Color resolve(std::span<const Color> samples) {
  Color mean(0.0);
  for (const Color& sample : samples) mean += sample / static_cast<double>(samples.size());
  for (int channel = 0; channel < 3; channel++) {
    if (mean[channel] < 0.0) mean[channel] = 0.0;
    if (mean[channel] > 1.0) mean[channel] = 1.0;
  }
  return mean;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
