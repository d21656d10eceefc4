#include "tests/support.hpp"

using namespace raylab;
using namespace raylab::test;

namespace {

/// A ray that arrives with direction d at the point of the sphere whose outward normal is n: from outside where d.n <= 0.
Hit hit_at(const Sphere& sphere, const Vec3& n, const Vec3& d) {
  const bool inside = dot(d, n) > 0;
  return {3, sphere.center + sphere.radius * n, d, inside ? -n : n, {5, inside ? Side::inwards : Side::outwards}};
}

/// Through the sphere as the handout goes, with angles and Snell's law twice: right to some 1e-8 near grazing.
Ray by_angles(const Sphere& sphere, double n, const Hit& hit) {
  const double theta_1 = std::acos(-dot(hit.direction, hit.normal));
  const double theta_2 = std::asin(std::sin(theta_1) / n);
  const Vec3 along_surface = unit(hit.direction - dot(hit.direction, hit.normal) * hit.normal);
  const Vec3 inner = std::sin(theta_2) * along_surface - std::cos(theta_2) * hit.normal;
  const Vec3 exit_point = hit.point + 2 * sphere.radius * std::cos(theta_2) * inner;
  const Vec3 exit_normal = (exit_point - sphere.center) / sphere.radius;
  const Vec3 along_exit = unit(inner - dot(inner, exit_normal) * exit_normal);
  return {exit_point, std::sin(theta_1) * along_exit + std::cos(theta_1) * exit_normal, {}};
}

double printed_schlick(double cosine, double n) {
  const double R0 = std::pow((1 - n) / (1 + n), 2);
  return R0 + (1 - R0) * std::pow(1 - cosine, 5);
}

const Sphere ball{{1, -2, 3}, 2};

}  // namespace

TEST_CASE("6.1 through_sphere: through the centre goes straight on, whatever the glass", "[stage6][6.1]") {
  for (const double n : {0.5, 1.0, 1.5, 3.0}) {
    const std::optional<Ray> exit = table().through_sphere(ball, n, hit_at(ball, {0, 0, -1}, {0, 0, 1}));
    REQUIRE(exit.has_value());
    CHECK(exit->origin == within(1e-15, Vec3(1, -2, 5)));
    CHECK(exit->direction == within(1e-15, Vec3(0, 0, 1)));
  }
}

TEST_CASE("6.1 through_sphere: glass of index 1 is air", "[stage6][6.1]") {
  Random random(12);
  for (int k = 0; k < 300; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n);
    if (dot(d, n) > -0.05 || dot(d, n) < -0.95) continue;  // where the angles themselves lose digits
    const Hit hit = hit_at(ball, n, d);
    const std::optional<Ray> exit = table().through_sphere(ball, 1, hit);
    REQUIRE(exit.has_value());
    CHECK(exit->direction == within(1e-13, d));
    CHECK(exit->origin == within(1e-13, hit.point - 2 * ball.radius * dot(d, n) * d));
  }
}

TEST_CASE("6.1 through_sphere: is Snell's law at both surfaces", "[stage6][6.1]") {
  Random random(13);
  for (int k = 0; k < 500; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n);
    if (dot(d, n) > -0.05 || dot(d, n) < -0.95) continue;  // where the angles themselves lose digits
    const double index = random.between(1.05, 3);
    const Hit hit = hit_at(ball, n, d);
    const std::optional<Ray> exit = table().through_sphere(ball, index, hit);
    const Ray expected = by_angles(ball, index, hit);
    REQUIRE(exit.has_value());
    CHECK(exit->origin == within(1e-12, expected.origin));
    CHECK(exit->direction == within(1e-12, expected.direction));
  }
}

TEST_CASE("6.1 through_sphere: leaves the sphere outwards, from its surface, with a unit direction", "[stage6][6.1]") {
  Random random(14);
  for (int k = 0; k < 500; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n);
    const std::optional<Ray> exit = table().through_sphere(ball, random.between(1, 10), hit_at(ball, n, d));
    REQUIRE(exit.has_value());
    CHECK(length(exit->origin - ball.center) == within(1e-14, ball.radius));
    CHECK(length(exit->direction) == within(4e-15, 1.0));
    CHECK(dot(exit->direction, exit->origin - ball.center) >= -1e-14);
    CHECK(exit->leaves.geometry == 5);
    CHECK(exit->leaves.side == Side::outwards);
  }
}

TEST_CASE("6.1 through_sphere: no light enters thin glass beyond the critical angle", "[stage6][6.1]") {
  const auto at_sine = [](double sine) { return hit_at(ball, {0, 1, 0}, {sine, -std::sqrt(1 - sine * sine), 0}); };
  CHECK(table().through_sphere(ball, 0.75, at_sine(0.74)).has_value());
  CHECK_FALSE(table().through_sphere(ball, 0.75, at_sine(0.76)).has_value());
  CHECK(table().through_sphere(ball, 1.5, at_sine(0.999999)).has_value());
}

TEST_CASE("6.1 through_sphere: a grazing ray gives numbers, not NaN", "[stage6][6.1]") {
  for (const double n : {1.0, 1.5}) {
    const std::optional<Ray> exit = table().through_sphere(ball, n, hit_at(ball, {0, 1, 0}, {1, 0, 0}));
    REQUIRE(exit.has_value());
    CHECK(length(exit->direction) == within(4e-15, 1.0));
    CHECK(std::isfinite(length(exit->origin)));
  }
}

TEST_CASE("6.2 schlick: is R0 straight on and 1 at grazing", "[stage6][6.2]") {
  CHECK(table().schlick(1, 1.5) == within(1e-16, 0.04));
  CHECK(table().schlick(0, 1.5) == within(1e-16, 1.0));
  CHECK(table().schlick(1, 1) == 0);
}

TEST_CASE("6.2 schlick: is equation 6", "[stage6][6.2]") {
  Random random(15);
  for (int k = 0; k < 300; ++k) {
    const double cosine = random.between(0, 1), n = random.between(0.1, 10);
    CHECK(table().schlick(cosine, n) == within(2e-15, printed_schlick(cosine, n)));
  }
}

TEST_CASE("6.2 schlick: stays within 0 to 1 where rounding brings the cosine beyond", "[stage6][6.2]") {
  CHECK(table().schlick(1 + 2.3e-16, 1) == 0);
  CHECK(table().schlick(1 + 1e-9, 1.5) == within(1e-16, 0.04));
  CHECK(table().schlick(-1e-9, 1.5) == within(1e-16, 1.0));
}

TEST_CASE("6.3 glass_bounces: from outside, the mirrored ray and the one through, weighted to 1", "[stage6][6.3]") {
  Random random(16);
  for (int k = 0; k < 300; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n);
    const double index = random.between(1, 3);
    const Hit hit = hit_at(ball, n, d);
    const GlassBounces both = table().glass_bounces(ball, index, hit);
    const double R = printed_schlick(-dot(d, n), index);
    CHECK(both.reflected.weight == within(1e-14, R));
    CHECK(both.refracted.weight == within(1e-14, 1 - R));
    CHECK(both.reflected.ray.origin == hit.point);
    CHECK(both.reflected.ray.direction == within(2e-15, d - 2 * dot(d, n) * n));
    CHECK(both.reflected.ray.leaves.geometry == 5);
    CHECK(both.reflected.ray.leaves.side == Side::outwards);
    if (dot(d, n) > -0.05 || dot(d, n) < -0.95) continue;
    CHECK(both.refracted.ray.origin == within(1e-11, by_angles(ball, index, hit).origin));
    CHECK(both.refracted.ray.direction == within(1e-11, by_angles(ball, index, hit).direction));
    CHECK(both.refracted.ray.leaves.geometry == 5);
    CHECK(both.refracted.ray.leaves.side == Side::outwards);
  }
}

TEST_CASE("6.3 glass_bounces: total reflection from outside is all mirror", "[stage6][6.3]") {
  const GlassBounces both = table().glass_bounces(ball, 0.75, hit_at(ball, {0, 1, 0}, {0.8, -0.6, 0}));
  CHECK(both.reflected.weight == 1);
  CHECK(both.refracted.weight == 0);
  CHECK(both.reflected.ray.direction == within(1e-15, Vec3(0.8, 0.6, 0)));
}

TEST_CASE("6.3 glass_bounces: from inside, one ray stays in and one goes out by Snell's law", "[stage6][6.3]") {
  // sin(phi_1) = 0.4 in glass of index 1.5: sin(phi_2) = 0.6 and cos(phi_2) = 0.8 in air.
  const Vec3 d(0.4, std::sqrt(1 - 0.16), 0);
  const Hit hit = hit_at(ball, {0, 1, 0}, d);
  const GlassBounces both = table().glass_bounces(ball, 1.5, hit);
  const double R = printed_schlick(0.8, 1.5);
  CHECK(both.reflected.weight == within(1e-15, R));
  CHECK(both.refracted.weight == within(1e-15, 1 - R));
  CHECK(both.reflected.ray.origin == hit.point);
  CHECK(both.reflected.ray.direction == within(1e-15, Vec3(d.x, -d.y, 0)));
  CHECK(both.reflected.ray.leaves.geometry == 5);
  CHECK(both.reflected.ray.leaves.side == Side::inwards);
  CHECK(both.refracted.ray.origin == hit.point);
  CHECK(both.refracted.ray.direction == within(1e-15, Vec3(0.6, 0.8, 0)));
  CHECK(both.refracted.ray.leaves.geometry == 5);
  CHECK(both.refracted.ray.leaves.side == Side::outwards);
}

TEST_CASE("6.3 glass_bounces: total reflection inside is all mirror", "[stage6][6.3]") {
  const GlassBounces both = table().glass_bounces(ball, 1.5, hit_at(ball, {0, 1, 0}, {0.8, 0.6, 0}));
  CHECK(both.reflected.weight == 1);
  CHECK(both.refracted.weight == 0);
  CHECK(both.reflected.ray.direction == within(1e-15, Vec3(0.8, -0.6, 0)));
  CHECK(both.reflected.ray.leaves.side == Side::inwards);
}
