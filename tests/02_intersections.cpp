#include "tests/support.hpp"

#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

Ray ray_from(const Vec3& origin, const Vec3& towards) { return {origin, towards / length(towards), {}}; }

std::optional<std::size_t> nearest_of(const std::vector<std::optional<double>>& distances) {
  std::vector<Candidate> candidates;
  for (const auto& t : distances) candidates.push_back({static_cast<GeometryId>(candidates.size() + 7), t});
  return table().nearest_hit(candidates);
}

const Sphere unit_sphere{{0, 0, 0}, 1};

}  // namespace

TEST_CASE("2.1 plane_hit: straight down onto the floor is the height", "[stage2][2.1]") {
  CHECK(table().plane_hit(ray_from({3, 5, -2}, {0, -1, 0}), {{0, 0, 0}, {0, 1, 0}}) == within(0, 5.0));
}

TEST_CASE("2.1 plane_hit: both sides of a plane are hit, and its normal's length does not matter", "[stage2][2.1]") {
  for (const double size : {0.125, 0.5, -3.0, 100.0}) {
    CHECK(table().plane_hit(ray_from({0, 5, 0}, {3, -4, 0}), {{1, 1, 1}, {0, size, 0}}) == within(1e-15, 5.0));
    CHECK(table().plane_hit(ray_from({0, -3, 0}, {3, 4, 0}), {{1, 1, 1}, {0, size, 0}}) == within(1e-15, 5.0));
  }
}

TEST_CASE("2.1 plane_hit: the normal may be 1e-200 or 1e200 long", "[stage2][2.1][hard]") {
  for (const double size : {1e-200, 1e200}) {
    CHECK(table().plane_hit(ray_from({0, 5, 0}, {3, -4, 0}), {{1, 1, 1}, {0, size, 0}}) == within(1e-15, 5.0));
    CHECK(table().plane_hit(ray_from({0, -3, 0}, {3, 4, 0}), {{1, 1, 1}, {0, size, 0}}) == within(1e-15, 5.0));
  }
}

TEST_CASE("2.1 plane_hit: behind is a miss, parallel and inside are misses", "[stage2][2.1]") {
  const Plane floor{{0, 0, 0}, {0, 1, 0}};
  CHECK(table().plane_hit(ray_from({0, 1, 0}, {1, 1, 0}), floor) == miss);
  CHECK(table().plane_hit(ray_from({0, 1, 0}, {1, 0, 0}), floor) == miss);
  CHECK(table().plane_hit(ray_from({0, 0, 0}, {1, 0, 0}), floor) == miss);
}

TEST_CASE("2.1 plane_hit: a parallel ray misses on either side, whichever way the normal points", "[stage2][2.1]") {
  for (const double side : {-1.0, 1.0})
    for (const double size : {-1.0, 1.0})
      CHECK(table().plane_hit(ray_from({0, side, 0}, {1, 0, 0}), {{0, 0, 0}, {0, size, 0}}) == miss);
}

TEST_CASE("2.1 plane_hit: a ray that starts on the plane hits it at 0", "[stage2][2.1]") {
  CHECK(table().plane_hit(ray_from({4, 0, 1}, {1, -1, 0}), {{0, 0, 0}, {0, 1, 0}}) == within(0, 0.0));
}

TEST_CASE("2.1 plane_hit: the point that is hit lies in the plane", "[stage2][2.1]") {
  Random random(4);
  int hits = 0;
  for (int k = 0; k < 1000; ++k) {
    const Ray ray{random.point(), random.direction(), {}};
    const Plane plane{random.point(), random.direction()};
    const std::optional<double> t = table().plane_hit(ray, plane);
    const double approach = dot(ray.direction, plane.normal), height = dot(ray.origin - plane.point, plane.normal);
    // In float, rounding decides the sign of a height near 0; and a ray this close to parallel may count as that.
    if (judging_submission() && (std::abs(height) < 0.001 || std::abs(approach) < 0.001)) continue;
    CHECK(t.has_value() == (approach * height <= 0));
    if (!t || std::abs(approach) < 0.01) continue;
    ++hits;
    // What the rounded approach is wrong by counts t times, and the height is of numbers of up to 20.
    CHECK(dot(ray.origin + *t * ray.direction - plane.point, plane.normal) ==
          within(1e-13 / std::abs(approach), 0.0, 20 + *t));
  }
  CHECK(hits > 300);
}

TEST_CASE("2.2 sphere_hit: the near side from outside, the far side from inside", "[stage2][2.2]") {
  CHECK(table().sphere_hit(ray_from({0, 0, -5}, {0, 0, 1}), unit_sphere) == within(0, 4.0));
  CHECK(table().sphere_hit(ray_from({0, 0, 0}, {0, 0, 1}), {{0, 0, 0}, 2}) == within(0, 2.0));
  CHECK(table().sphere_hit(ray_from({0, 0, 0.5}, {0, 0, 1}), unit_sphere) == within(0, 0.5));
  CHECK(table().sphere_hit(ray_from({0, 0, 0.5}, {0, 0, -1}), unit_sphere) == within(0, 1.5));
}

TEST_CASE("2.2 sphere_hit: a touch hits, a near miss misses, what lies behind misses", "[stage2][2.2]") {
  CHECK(table().sphere_hit(ray_from({-5, 1, 0}, {1, 0, 0}), unit_sphere) == within(0, 5.0));
  CHECK(table().sphere_hit(ray_from({-5, 1.01, 0}, {1, 0, 0}), unit_sphere) == miss);
  CHECK(table().sphere_hit(ray_from({0, 0, 5}, {0, 0, 1}), unit_sphere) == miss);
}

TEST_CASE("2.2 sphere_hit: a ray that passes by at a ten millionth misses", "[stage2][2.2][hard]") {
  CHECK(table().sphere_hit(ray_from({-5, 1.0000001, 0}, {1, 0, 0}), unit_sphere) == miss);
}

TEST_CASE("2.2 sphere_hit: a ray that starts on the sphere hits it at 0", "[stage2][2.2]") {
  CHECK(table().sphere_hit(ray_from({1, 0, 0}, {1, 0, 0}), unit_sphere) == within(0, 0.0));
  CHECK(table().sphere_hit(ray_from({1, 0, 0}, {-1, 0, 0}), unit_sphere) == within(0, 0.0));
}

TEST_CASE("2.2 sphere_hit: the point that is hit lies on the sphere, and nothing of it nearer", "[stage2][2.2]") {
  Random random(5);
  int hits = 0;
  for (int k = 0; k < 2000; ++k) {
    const Sphere sphere{random.point(3), random.between(0.1, 3)};
    const Vec3 origin = random.point();
    const Ray ray = ray_from(origin, sphere.center + random.point(1.5 * sphere.radius) - origin);
    const std::optional<double> t = table().sphere_hit(ray, sphere);
    if (!t) continue;
    ++hits;
    CHECK(*t >= 0);
    // The quadratic's terms are as large as the squared distance of the center, and so is what they are rounded by. That
    // moves the squared distance of the point that is hit, and its distance by 1/2R of that: near a tangent, too, where t
    // itself is off by far more.
    const double squared = dot(origin - sphere.center, origin - sphere.center);
    CHECK(length(ray.origin + *t * ray.direction - sphere.center) ==
          within(1e-12, sphere.radius, 10 + squared / (2 * sphere.radius)));
    if (judging_submission() && *t < 0.1) continue;  // in float, rounding decides on which side the ray starts
    const bool inside = length(origin - sphere.center) < sphere.radius;
    for (const double part : {0.25, 0.5, 0.75})
      CHECK((length(ray.origin + part * *t * ray.direction - sphere.center) < sphere.radius) == inside);
  }
  CHECK(hits > 500);
}

TEST_CASE("2.2 sphere_hit: hits exactly the rays that pass the centre within the radius", "[stage2][2.2]") {
  Random random(6);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 n = random.direction(), across = unit(cross(n, random.direction()));
    const double offset = random.between(0, 2);
    // The discriminant is 1 - offset^2, of terms as large as 20^2.
    if (std::abs(offset * offset - 1) < allowed(2e-9, 400)) continue;
    const Ray ray{-20.0 * n + offset * across, n, {}};
    const std::optional<double> t = table().sphere_hit(ray, unit_sphere);
    CHECK(t.has_value() == (offset < 1));
    const double half_chord = std::sqrt(std::max(0.0, 1 - offset * offset));
    if (t && offset < 0.999) CHECK(*t == within(1e-12, 20 - half_chord, 20 + 400 / (2 * half_chord)));
  }
}

TEST_CASE("2.2 sphere_hit: a small sphere has its size", "[stage2][2.2]") {
  const Sphere bead{{0, 0, 0}, 0.125};
  CHECK(table().sphere_hit(ray_from({0, 0.09375, -8}, {0, 0, 1}), bead).has_value());
  CHECK(table().sphere_hit(ray_from({0, 0.15625, -8}, {0, 0, 1}), bead) == miss);
}

// The textbook's discriminant loses the radius to the squared distance, in double as well.
TEST_CASE("2.2 sphere_hit: a small, far sphere keeps its size", "[stage2][2.2][hard]") {
  const Sphere speck{{0, 0, 0}, 0x1p-10};
  CHECK(table().sphere_hit(ray_from({0, 0x1p-11, -0x1p27}, {0, 0, 1}), speck).has_value());
  CHECK(table().sphere_hit(ray_from({0, 0x1p-9, -0x1p27}, {0, 0, 1}), speck) == miss);
}

TEST_CASE("2.3 sphere_normal: is unit and points away from the centre", "[stage2][2.3]") {
  CHECK(table().sphere_normal({{1, 2, 3}, 4}, {1, 6, 3}) == within(0, Vec3(0, 1, 0)));
  CHECK(table().sphere_normal({{1, 2, 3}, 4}, {-3, 2, 3}) == within(0, Vec3(-1, 0, 0)));
  Random random(7);
  for (int k = 0; k < 500; ++k) {
    const Vec3 n = random.direction();
    const Sphere sphere{random.point(), random.between(0.5, 5)};
    // Rounded are center and point, up to 15 in size; the quotient by the radius is the normal.
    CHECK(table().sphere_normal(sphere, sphere.center + sphere.radius * n) == within(2e-14, n, 15 / sphere.radius));
  }
}

TEST_CASE("2.4 nearest_hit: is the least distance, wherever it stands in the list", "[stage2][2.4]") {
  CHECK(nearest_of({3.0, 1.0, 2.0}) == std::optional<std::size_t>(1));
  CHECK(nearest_of({1.0, 3.0, 2.0}) == std::optional<std::size_t>(0));
  CHECK(nearest_of({3.0, 2.0, 1.0}) == std::optional<std::size_t>(2));
  CHECK(nearest_of({3.0, 0.0, 1.0}) == std::optional<std::size_t>(1));
}

TEST_CASE("2.4 nearest_hit: misses do not count, and nothing but misses is a miss", "[stage2][2.4]") {
  CHECK(nearest_of({{}, 5.0, {}, 4.0, {}}) == std::optional<std::size_t>(3));
  CHECK(nearest_of({{}, {}, 1e20}) == std::optional<std::size_t>(2));
  CHECK_FALSE(nearest_of({{}, {}}).has_value());
  CHECK_FALSE(nearest_of({}).has_value());
}

TEST_CASE("2.4 nearest_hit: no distance is too far", "[stage2][2.4][hard]") {
  CHECK(nearest_of({{}, {}, 1e300}) == std::optional<std::size_t>(2));
}

TEST_CASE("2.4 nearest_hit: of equal distances the first in the list wins", "[stage2][2.4]") {
  CHECK(nearest_of({2.0, 1.0, 1.0, 1.0}) == std::optional<std::size_t>(1));
}
