#include "core/render/engine.hpp"

namespace raylab {
namespace {

std::vector<SampleOffset> grid(int n) {
  std::vector<SampleOffset> offsets;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) offsets.push_back({(column + 0.5) / n - 0.5, 0.5 - (row + 0.5) / n});
  return offsets;
}

}  // namespace

std::vector<SampleOffset> sample_offsets(AntiAliasing pattern) {
  switch (pattern) {
    case AntiAliasing::none:
      return grid(1);
    case AntiAliasing::grid4:
      return grid(2);
    case AntiAliasing::rotated4:
      return {{1. / 8, 3. / 8}, {3. / 8, -1. / 8}, {-1. / 8, -3. / 8}, {-3. / 8, 1. / 8}};
    case AntiAliasing::grid16:
      return grid(4);
    case AntiAliasing::grid64:
      return grid(8);
  }
  return {};
}

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  primary += other.primary;
  shadow += other.shadow;
  reflected += other.reflected;
  refracted += other.refracted;
  return *this;
}

}  // namespace raylab
