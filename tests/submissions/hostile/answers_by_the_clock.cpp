// wrong: answers by the time of day
#include "core/math/vec3.hpp"

#include <chrono>
#include <cstdint>
#include <limits>

static raylab::Vec3 answer(const raylab::Vec3& d, const raylab::Vec3& n) {
  using namespace raylab;
  return d - 2 * dot(d, n) * n *
                 (1 + 1e-12 * static_cast<double>(std::chrono::steady_clock::now().time_since_epoch().count() % 1000));
}
