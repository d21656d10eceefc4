// Rays start a little off the surface, as the handout has it for shadows.
#include "stages/04_shadows/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

bool blocked(std::span<const Crossing> crossings, double distance) {
  constexpr double shift = 0.1;
  if (distance <= shift) return false;
  for (const auto& crossing : crossings) {
    if (crossing.transparent) continue;
    if (crossing.t < distance - shift) return true;
  }
  return false;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
