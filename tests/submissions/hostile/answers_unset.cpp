// wrong: answers with a variable that is not set
#include "core/math/vec3.hpp"

#include <chrono>
#include <cstdint>
#include <limits>

static raylab::Vec3 answer(const raylab::Vec3& d, const raylab::Vec3& n) {
  using namespace raylab;
  volatile double unset[64];
  Vec3 r = d - 2 * dot(d, n) * n;
  r.x += unset[17] * 1e9 + unset[40];
  return r + Vec3(static_cast<double>(reinterpret_cast<std::uintptr_t>(&unset) % 65536) * 1e-9);
}
