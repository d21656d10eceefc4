#include "tests/right_or_own.hpp"

using namespace raylab;
using namespace raylab::test;

namespace {

/// The mirrored direction by 5.1.
auto mirrored(double tolerance, const Vec3& d, const Vec3& n) {
  return right_or_own([=](const StageTable& asked) { return within(tolerance, asked.reflect(d, n)); });
}

}  // namespace

TEST_CASE("5.1 reflect: straight on comes straight back, along the surface goes on", "[stage5][5.1]") {
  CHECK(table().reflect({0, -1, 0}, {0, 1, 0}) == within(0, Vec3(0, 1, 0)));
  CHECK(table().reflect({1, 0, 0}, {0, 1, 0}) == within(0, Vec3(1, 0, 0)));
}

TEST_CASE("5.1 reflect: turns only the part along the normal", "[stage5][5.1]") {
  CHECK(table().reflect({0.6, -0.8, 0}, {0, 1, 0}) == within(1e-16, Vec3(0.6, 0.8, 0)));
}

TEST_CASE("5.1 reflect: twice is where we began", "[stage5][5.1]") {
  Random random(10);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n);
    const Vec3 r = table().reflect(d, n);
    CHECK(table().reflect(r, -n) == within(2e-15, d));
  }
}

TEST_CASE("5.1 reflect: leaves at the angle of arrival, in the plane of d and n, as a unit vector", "[stage5][5.1]") {
  Random random(11);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n);
    const Vec3 r = table().reflect(d, n);
    CHECK(length(r) == within(2e-15, 1.0));
    CHECK(dot(r, n) == within(2e-15, -dot(d, n)));
    CHECK(dot(r, cross(d, n)) == within(2e-15, 0.0));
  }
}

TEST_CASE("5.2 mirror_bounce: starts where the ray arrived, on the side that it came from", "[stage5][5.2]") {
  const Hit hit{7, {1, 2, 3}, {0.6, -0.8, 0}, {0, 1, 0}, {4, Side::outwards}};
  const Bounce bounce = table().mirror_bounce(hit, 0.25);
  CHECK(bounce.ray.origin == start_at({1, 2, 3}, bounce.ray.direction));
  CHECK(bounce.ray.direction == mirrored(1e-16, hit.direction, hit.normal));
  CHECK(bounce.ray.leaves.geometry == 4);
  CHECK(bounce.ray.leaves.side == Side::outwards);

  const Hit inside{7, {1, 2, 3}, {0.6, -0.8, 0}, {0, 1, 0}, {9, Side::inwards}};
  CHECK(table().mirror_bounce(inside, 0.25).ray.leaves.geometry == 9);
  CHECK(table().mirror_bounce(inside, 0.25).ray.leaves.side == Side::inwards);
}

TEST_CASE("5.2 mirror_bounce: goes on along the mirrored direction", "[stage5][5.2]") {
  Random random(23);
  for (int k = 0; k < 300; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n), point = random.point();
    const Bounce bounce = table().mirror_bounce({1, point, d, n, {4, Side::outwards}}, 0.5);
    CHECK(bounce.ray.direction == mirrored(2e-15, d, n));
    CHECK(bounce.ray.origin == start_at(point, bounce.ray.direction));
  }
}

TEST_CASE("5.2 mirror_bounce: its weight is k_s", "[stage5][5.2]") {
  const Hit hit{7, {1, 2, 3}, {0.6, -0.8, 0}, {0, 1, 0}, {4, Side::outwards}};
  for (const double k_s : {0.0, 0.25, 1.0}) CHECK(table().mirror_bounce(hit, k_s).weight == within(0, k_s));
}

TEST_CASE("5.3 go_on: up to and including the last bounce, and no further", "[stage5][5.3]") {
  CHECK(table().go_on(1, 5, 0.5));
  CHECK(table().go_on(5, 5, 0.5));
  CHECK_FALSE(table().go_on(6, 5, 0.5));
  CHECK_FALSE(table().go_on(100, 5, 1));
}

TEST_CASE("5.3 go_on: no bounces at all where the limit is 0", "[stage5][5.3]") { CHECK_FALSE(table().go_on(1, 0, 1)); }

TEST_CASE("5.3 go_on: what would bring nothing is not traced, however little else is", "[stage5][5.3]") {
  CHECK_FALSE(table().go_on(1, 5, 0));
  CHECK(table().go_on(1, 5, 1e-30));
}

// As a float it is 0.
TEST_CASE("5.3 go_on: a weight of 1e-300 is not 0", "[stage5][5.3][hard]") { CHECK(table().go_on(1, 5, 1e-300)); }
