// wrong: answers with what is no number
#include "core/math/vec3.hpp"

#include <chrono>
#include <cstdint>
#include <limits>

static raylab::Vec3 answer(const raylab::Vec3& d, const raylab::Vec3& n) {
  using namespace raylab;
  return Vec3(std::numeric_limits<double>::quiet_NaN());
}
