#include "stages/07_ssaa/stage.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <iterator>

namespace raylab::RAYLAB_IMPLEMENTATION {

std::vector<SampleOffset> sample_positions() {
  // In eighths of a pixel.
  constexpr std::array<std::array<int, 2>, 4> places{{{1, 3}, {3, -1}, {-1, -3}, {-3, 1}}};
  std::vector<SampleOffset> offsets;
  std::ranges::transform(places, std::back_inserter(offsets), [](const auto& place) {
    return SampleOffset{place[0] / 8.0, place[1] / 8.0};
  });
  return offsets;
}

Color resolve(std::span<const Color> samples) {
  Color mean(0);
  double seen = 0;
  for (const Color& sample : samples) mean = mean * (seen / (seen + 1)) + sample / (seen + 1), ++seen;
  return glm::clamp(mean, 0.0, 1.0);
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
