// wrong: answers by where things lie in memory
#include "core/math/vec3.hpp"

#include <chrono>
#include <cstdint>
#include <limits>

static raylab::Vec3 answer(const raylab::Vec3& d, const raylab::Vec3& n) {
  using namespace raylab;
  const int here = 0;
  return d - 2 * dot(d, n) * n * (1 + 1e-13 * static_cast<double>((reinterpret_cast<std::uintptr_t>(&here) >> 12U) % 1000));
}
