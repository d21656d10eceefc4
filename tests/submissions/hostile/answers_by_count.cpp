// wrong: answers a little more each time
#include "core/math/vec3.hpp"

#include <chrono>
#include <cstdint>
#include <limits>

static raylab::Vec3 answer(const raylab::Vec3& d, const raylab::Vec3& n) {
  using namespace raylab;
  static int calls = 0;
  return d - 2 * dot(d, n) * n * (1 + 1e-12 * ++calls);
}
