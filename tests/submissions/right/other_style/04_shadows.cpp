#include "stages/04_shadows/stage.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <vector>

namespace raylab::RAYLAB_IMPLEMENTATION {

bool blocked(std::span<const Crossing> crossings, double distance) {
  std::vector<Crossing> stones;
  std::ranges::copy_if(crossings, std::back_inserter(stones), [](const Crossing& c) { return !c.transparent; });
  std::ranges::sort(stones, {}, &Crossing::t);
  return !stones.empty() && stones.front().t < distance;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
