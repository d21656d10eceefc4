#include "core/render/engine.hpp"

#include <algorithm>

namespace raylab {
namespace {

std::vector<SampleOffset> grid(int n) {
  std::vector<SampleOffset> offsets;
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) offsets.push_back({(column + 0.5) / n - 0.5, 0.5 - (row + 0.5) / n});
  return offsets;
}

/// The samples of a 4 x 4 grid, those of the rotated grid before the others.
std::vector<SampleOffset> rotated_first(std::vector<SampleOffset> samples) {
  const std::vector<SampleOffset> rotated = sample_offsets(AntiAliasing::rotated4);
  const auto is_rotated = [&](const SampleOffset& a) {
    return std::any_of(rotated.begin(), rotated.end(), [&](const SampleOffset& b) { return a.dx == b.dx && a.dy == b.dy; });
  };
  std::stable_partition(samples.begin(), samples.end(), is_rotated);
  return samples;
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
    case AntiAliasing::grid1024:
      return grid(32);
    case AntiAliasing::adaptive:
      return rotated_first(grid(4));
  }
  return {};
}

std::string_view aa_name(AntiAliasing pattern) {
  return std::find_if(aa_patterns.begin(), aa_patterns.end(), [&](const auto& named) { return named.second == pattern; })
      ->first;
}

bool samples_agree(std::span<const Color> samples) {
  Color least(1), greatest(0);
  for (const Color& sample : samples) {
    const Color seen = clamp(sample, 0.0, 1.0);
    if (!is_finite(seen)) return false;
    least = min(least, seen);
    greatest = max(greatest, seen);
  }
  const Color apart = greatest - least;
  return std::max({apart.r, apart.g, apart.b}) <= agreeing_samples;
}

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  primary += other.primary;
  shadow += other.shadow;
  reflected += other.reflected;
  refracted += other.refracted;
  return *this;
}

}  // namespace raylab
