#include "tests/support.hpp"

#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

Color resolve(const std::vector<Color>& samples) { return table().resolve(samples); }

}  // namespace

TEST_CASE("7.1 sample_positions: are the handout's four, in its order", "[stage7][7.1]") {
  const std::vector<SampleOffset> positions = table().sample_positions();
  const double expected[4][2] = {{0.125, 0.375}, {0.375, -0.125}, {-0.125, -0.375}, {-0.375, 0.125}};
  REQUIRE(positions.size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(positions[k].dx == within(0, expected[k][0]));
    CHECK(positions[k].dy == within(0, expected[k][1]));
  }
}

TEST_CASE("7.2 resolve: one sample is itself, equal samples too", "[stage7][7.2]") {
  CHECK(resolve({{0.25, 0.5, 0.75}}) == within(0, Color(0.25, 0.5, 0.75)));
  // A thousand additions, each of which may be off by half a unit of the sum.
  CHECK(resolve(std::vector<Color>(1024, Color(0.1))) == within(1e-13, Color(0.1), 1024 * 0.1 / 64));
}

TEST_CASE("7.2 resolve: is the mean of each component by itself", "[stage7][7.2]") {
  CHECK(resolve({{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 0.5}}) == within(1e-16, Color(0.25, 0.5, 0.125)));
  CHECK(resolve({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == within(1e-15, Color(1. / 3)));
}

TEST_CASE("7.2 resolve: clamps once, after the mean", "[stage7][7.2]") {
  CHECK(resolve({Color(2), Color(0), Color(0), Color(0)}) == within(1e-16, Color(0.5)));
  CHECK(resolve({Color(10), Color(0), Color(0), Color(0)}) == Color(1));
  CHECK(resolve({Color(-0.5), Color(0.25), Color(0.25), Color(0.25)}) == within(1e-16, Color(0.0625)));
  CHECK(resolve({Color(-1)}) == Color(0));
}

TEST_CASE("7.2 resolve: a sum beyond all numbers is white, a NaN stays one", "[stage7][7.2]") {
  CHECK(resolve(std::vector<Color>(4, Color(1.5e308))) == Color(1));
  const Color spoilt = resolve({{std::nan(""), 0.5, 0.5}, Color(0.5)});
  CHECK(std::isnan(spoilt.r));
  CHECK(spoilt.g == within(1e-16, 0.5));
}
