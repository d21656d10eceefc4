#include "tests/support.hpp"

#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

bool blocked(const std::vector<Crossing>& crossings, double distance) { return table().blocked(crossings, distance); }

constexpr Crossing opaque(double t) { return {t, false}; }
constexpr Crossing glass(double t) { return {t, true}; }

}  // namespace

TEST_CASE("4.1 blocked: nothing in the way lets the light through", "[stage4][4.1]") {
  CHECK_FALSE(blocked({}, 3));
  CHECK_FALSE(blocked({}, infinity));
}

TEST_CASE("4.1 blocked: what is opaque and nearer than the light blocks it", "[stage4][4.1]") {
  CHECK(blocked({opaque(2)}, 3));
  CHECK(blocked({opaque(1e9)}, infinity));
}

TEST_CASE("4.1 blocked: what is close to the point or to the light blocks it too", "[stage4][4.1]") {
  CHECK(blocked({opaque(0)}, 3));
  CHECK(blocked({opaque(1e-9)}, infinity));
  // Just before the shift of 0.1 that is accepted: t < distance - shift.
  CHECK(blocked({opaque(2.875)}, 3));
}

TEST_CASE("4.1 blocked: nothing is too close to the light", "[stage4][4.1][hard]") {
  CHECK(blocked({opaque(3 - 1e-9)}, 3));
  CHECK(blocked({opaque(0.01)}, 0.02));
}

TEST_CASE("4.1 blocked: what is farther than the light, or just at it, does not block", "[stage4][4.1]") {
  CHECK_FALSE(blocked({opaque(4)}, 3));
  CHECK_FALSE(blocked({opaque(3)}, 3));
}

TEST_CASE("4.1 blocked: glass never blocks", "[stage4][4.1]") {
  CHECK_FALSE(blocked({glass(1), glass(2)}, 3));
  CHECK_FALSE(blocked({glass(1)}, infinity));
}

TEST_CASE("4.1 blocked: one blocker is enough, wherever it stands in the list", "[stage4][4.1]") {
  CHECK(blocked({opaque(1), opaque(8), glass(2)}, 3));
  CHECK(blocked({opaque(8), glass(2), opaque(1)}, 3));
  CHECK(blocked({glass(0.5), opaque(1), opaque(8)}, 3));
}

TEST_CASE("4.1 blocked: is a function of the whole list in any order", "[stage4][4.1]") {
  Random random(9);
  for (int k = 0; k < 500; ++k) {
    std::vector<Crossing> crossings;
    bool expected = false;
    for (double n = random.between(0, 5); n > 0; --n) {
      crossings.push_back({random.between(0.2, 6), random.between(0, 1) < 0.5});
      // Rays that start 0.1 off the surface, an accepted variant, do not ask just before the light.
      if (judging_submission() && std::abs(crossings.back().t - 3) < 0.11) crossings.back().t += 1;
      expected = expected || (!crossings.back().transparent && crossings.back().t < 3);
    }
    CHECK(blocked(crossings, 3) == expected);
    CHECK(blocked({crossings.rbegin(), crossings.rend()}, 3) == expected);
  }
}
