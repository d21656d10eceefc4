#include "stages/04_shadows/stage.hpp"

#include <algorithm>

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 4.1: is the light kept from a point?
bool blocked(std::span<const Crossing> crossings, double distance) {
  return std::any_of(crossings.begin(), crossings.end(),
                     [&](const Crossing& crossing) { return !crossing.transparent && crossing.t < distance; });
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
