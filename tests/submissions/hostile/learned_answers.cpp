// wrong: knows the first answers by heart
#include "core/math/vec3.hpp"

static raylab::Vec3 answer(const raylab::Vec3&, const raylab::Vec3&) {
  using raylab::Vec3;
  static const Vec3 learned[] = {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, -1)};
  static unsigned calls = 0;
  return learned[calls++ % 3];
}
