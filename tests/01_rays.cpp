#include "tests/support.hpp"

using namespace raylab;
using namespace raylab::test;

namespace {

Camera camera_towards(const Vec3& facing, const Vec3& up, double half_field_of_view = 45) {
  return {{1, 2, 3}, facing, up, half_field_of_view};
}

/// The ray's point on the plane at distance 1 before a camera that faces -z with y up: x to the right, y up.
Vec3 on_screen(const Ray& ray) { return ray.direction / -ray.direction.z; }

const Camera straight = camera_towards({0, 0, -1}, {0, 1, 0});

}  // namespace

TEST_CASE("1.1 camera_ray: starts at the camera and leaves nothing", "[stage1][1.1]") {
  const Ray ray = table().camera_ray(straight, 4, 3, 1, 0.5, 0, 0);
  CHECK(ray.origin == within(0, Vec3(1, 2, 3)));
  CHECK(ray.leaves.geometry == no_geometry);
}

TEST_CASE("1.1 camera_ray: the middle of the image looks along the facing vector", "[stage1][1.1]") {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Vec3 facing = random.point(), up = random.direction();
    const Ray ray = table().camera_ray(camera_towards(facing, up), 5, 3, 0.5, 0.5, 0, 0);
    CHECK(ray.direction == within(1e-15, facing / length(facing)));
  }
}

TEST_CASE("1.1 camera_ray: x runs to the right and y up, from a half", "[stage1][1.1]") {
  // 4 x 4 pixels, 45 degrees: the screen at distance 1 reaches from -1 to 1, so a pixel is 1/2 wide.
  const Vec3 first = on_screen(table().camera_ray(straight, 4, 4, -1, 2, 0, 0));  // top left
  CHECK(first == within(1e-15, Vec3(-0.75, 0.75, -1)));
  const Vec3 last = on_screen(table().camera_ray(straight, 4, 4, 2, -1, 0, 0));  // bottom right
  CHECK(last == within(1e-15, Vec3(0.75, -0.75, -1)));
}

TEST_CASE("1.1 camera_ray: the field of view belongs to the longer side, wide or high", "[stage1][1.1]") {
  const Camera camera = camera_towards({0, 0, -1}, {0, 1, 0}, 30);
  const double edge = std::tan(pi / 6);
  // Half a pixel beyond the outermost centre lies the edge.
  CHECK(on_screen(table().camera_ray(camera, 8, 2, 4, 0.5, 0.5, 0)).x == within(1e-15, edge));
  CHECK(on_screen(table().camera_ray(camera, 2, 8, 0.5, 4, 0, 0.5)).y == within(1e-15, edge));
  CHECK(on_screen(table().camera_ray(camera, 8, 2, 0.5, 1, 0, 0.5)).y == within(1e-15, edge / 4));
  // Odd sizes have no pixels less.
  CHECK(on_screen(table().camera_ray(camera, 5, 3, 2.5, 0.5, 0.5, 0)).x == within(1e-15, edge));
  CHECK(on_screen(table().camera_ray(camera, 3, 5, 0.5, 2.5, 0, 0.5)).y == within(1e-15, edge));
}

TEST_CASE("1.1 camera_ray: dx and dy move the ray by parts of a pixel, up for dy > 0", "[stage1][1.1]") {
  const Vec3 moved = on_screen(table().camera_ray(straight, 4, 4, 0, 1, 0.125, 0.375));
  CHECK(moved == within(1e-15, Vec3(-0.25 + 0.0625, 0.25 + 0.1875, -1)));
}

TEST_CASE("1.1 camera_ray: looks the same way round, wherever facing and up point", "[stage1][1.1]") {
  Random random(21);
  for (int k = 0; k < 300; ++k) {
    const Vec3 f = random.direction(), up = random.direction();
    const double sine = length(cross(f, up));
    if (sine < 0.1) continue;
    const Vec3 r = cross(f, up) / sine, u = cross(r, f);
    const double x = random.between(-4, 4), y = random.between(-3, 3);
    const Vec3 expected = f + (x - 0.5) / 4 * r + (y - 0.5) / 4 * u;
    CHECK(table().camera_ray(camera_towards(f, up), 8, 6, x, y, 0, 0).direction ==
          within(1e-14, expected / length(expected), 1 / sine));
  }
}

namespace {

/// The same rays where facing and up have any length from 10^-decades to 10^decades.
void check_lengths(unsigned seed, double decades) {
  Random random(seed);
  for (int k = 0; k < 300; ++k) {
    const double facing_length = std::pow(10, random.between(-decades, decades)),
                 up_length = std::pow(10, random.between(-decades, decades));
    const Vec3 facing = random.direction(), up = random.direction();
    const double sine = length(cross(facing, up));
    if (sine < 0.1) continue;
    const double x = random.between(-5, 5), y = random.between(-5, 5), theta = random.between(1, 89);
    const Ray plain = table().camera_ray(camera_towards(facing, up, theta), 10, 10, x, y, 0, 0);
    const Ray scaled = table().camera_ray(camera_towards(facing * facing_length, up * up_length, theta), 10, 10, x, y, 0, 0);
    CHECK(length(plain.direction) == within(4e-16, 1.0));
    CHECK(length(scaled.direction) == within(4e-16, 1.0));
    CHECK(scaled.direction == within(1e-15, plain.direction, 1 / sine));
  }
}

}  // namespace

TEST_CASE("1.1 camera_ray: directions are unit, whatever the lengths of facing and up", "[stage1][1.1]") {
  check_lengths(22, 3);
}

// In float even the squares of much smaller and larger numbers vanish or overflow.
TEST_CASE("1.1 camera_ray: facing and up may be 1e-200 or 1e200 long", "[stage1][1.1][hard]") { check_lengths(2, 200); }

TEST_CASE("1.1 camera_ray: an up vector that leans still gives an upright, square picture", "[stage1][1.1]") {
  const Camera leaning = camera_towards({0, 0, -2}, {0, 3, -3});
  CHECK(on_screen(table().camera_ray(leaning, 4, 4, 2, 2, 0, 0)) == within(1e-15, Vec3(0.75, 0.75, -1)));
}

TEST_CASE("1.1 camera_ray: mirrored pixels have mirrored rays", "[stage1][1.1]") {
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const double x = random.between(-50, 50), y = random.between(-50, 50);
    const Vec3 right = on_screen(table().camera_ray(straight, 101, 100, 0.5 + x, 0.5 + y, 0, 0));
    const Vec3 left = on_screen(table().camera_ray(straight, 101, 100, 0.5 - x, 0.5 + y, 0, 0));
    CHECK(left == within(1e-15, Vec3(-right.x, right.y, -1), 2));
  }
}
