#include "tests/support.hpp"

using namespace raylab;
using namespace raylab::test;

TEST_CASE("8.1 depth_cue: nothing is lost on no way, and all on a very long one", "[stage8][8.1]") {
  const Seen near{Color(0.5), {}, 0.0, Color(0, 0, 1), 0};
  const Seen far{Color(0.5), {}, 1e6, Color(0, 0, 1), 0};
  CHECK(table().depth_cue(near) == within(1e-15, Color(0.5)));
  CHECK(table().depth_cue(far) == within(1e-15, Color(0, 0, 1)));
}

TEST_CASE("8.1 depth_cue: half is left after 20 ln 2, and the background is never hazy", "[stage8][8.1]") {
  const Seen half{Color(1, 0, 0), {}, 20 * std::log(2.0), Color(0, 0, 1), 0};
  CHECK(table().depth_cue(half) == within(1e-15, Color(0.5, 0, 0.5)));
  CHECK(table().depth_cue({Color(0.3), {}, {}, Color(0.3), 0}) == Color(0.3));
}
