#include "stages/04_shadows/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

bool blocked(std::span<const Crossing> crossings, double distance) {
  const auto limit = static_cast<float>(distance);
  for (const Crossing& crossing : crossings)
    if (!crossing.transparent && static_cast<float>(crossing.t) < limit) return true;
  return false;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
