#include "stages/07_ssaa/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

/// A square of half diagonal sqrt(5/32), turned by atan(3) from the x axis, corner after corner clockwise.
std::vector<SampleOffset> sample_positions() {
  const float radius = std::sqrt(5.0f / 32.0f);
  const float first = std::atan2(3.0f, 1.0f), quarter = std::acos(0.0f);
  std::vector<SampleOffset> positions;
  for (int k = 0; k < 4; ++k) {
    const float angle = first - static_cast<float>(k) * quarter;
    positions.push_back({static_cast<double>(radius * std::cos(angle)), static_cast<double>(radius * std::sin(angle))});
  }
  return positions;
}

Color resolve(std::span<const Color> samples) {
  glm::vec3 sum(0.0f);
  for (const Color& sample : samples) sum += glm::vec3(sample);
  sum /= static_cast<float>(samples.size());
  const auto clamped = [](float value) { return static_cast<double>(std::clamp(value, 0.0f, 1.0f)); };
  return {clamped(sum.r), clamped(sum.g), clamped(sum.b)};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
