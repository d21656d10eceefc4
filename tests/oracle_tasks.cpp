// The oracle's answers to single tasks, beside the solution's and beside answers that are known.

#include "reference/oracle/tasks.hpp"

#include "tests/support.hpp"

#include <stdexcept>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

const StageTable& oracle() {
  static const StageTable table = oracle_table();
  return table;
}

void check_same(const Ray& a, const Ray& b) {
  CHECK(a.origin == within(1e-13, b.origin));
  CHECK(a.direction == within(1e-13, b.direction));
  CHECK(a.leaves.geometry == b.leaves.geometry);
  CHECK(a.leaves.side == b.leaves.side);
}

const Ray down_z{{0, 0, 5}, {0, 0, -1}, {}};

}  // namespace

TEST_CASE("oracle tasks: every task of the seven stages has an answer near the solution's", "[oracle]") {
  Random random(3);
  for (int k = 0; k < 50; ++k) {
    const Vec3 n = random.direction(), d = random.arriving_at(n), v = random.arriving_at(-n), c = random.point();
    const Camera camera{c, random.point(), random.point(), random.between(1, 80)};
    check_same(table().camera_ray(camera, 640, 480, 7.5, -3, 0.25, 0.5),
               oracle().camera_ray(camera, 640, 480, 7.5, -3, 0.25, 0.5));
    const Ray ray{random.point(), d, {}};
    const Plane plane{c, random.point()};
    const std::optional<double> t = oracle().plane_hit(ray, plane);
    REQUIRE(table().plane_hit(ray, plane).has_value() == t.has_value());
    if (t) CHECK(*table().plane_hit(ray, plane) == within(1e-12 * (1 + *t * *t), *t));
    const Sphere sphere{c, random.between(1, 9)};
    CHECK(table().sphere_hit(ray, sphere).value_or(-1) == within(1e-11, oracle().sphere_hit(ray, sphere).value_or(-1)));
    CHECK(table().sphere_normal(sphere, ray.origin) == within(1e-15, oracle().sphere_normal(sphere, ray.origin)));
    const Material material{Color(1, 0.5, 0), random.between(0, 300), false, 1.5};
    CHECK(table().specular_weight(material.shininess) == within(1e-15, oracle().specular_weight(material.shininess)));
    const Vec3 l = random.direction();
    const PointLight lamp{random.point(), 40};
    const DirectionalLight sun{random.point(), 0.5};
    CHECK(table().blinn_phong(l, n, v, 2, Color(1), 100) == within(1e-13, oracle().blinn_phong(l, n, v, 2, Color(1), 100)));
    CHECK(table().point_light(lamp, c, n, v, material) == within(1e-13, oracle().point_light(lamp, c, n, v, material)));
    CHECK(table().directional_light(sun, n, v, material) == within(1e-13, oracle().directional_light(sun, n, v, material)));
    CHECK(table().ambient_light({0.1}, material) == within(1e-16, oracle().ambient_light({0.1}, material)));
    CHECK(table().reflect(d, n) == within(1e-15, oracle().reflect(d, n)));
    const Hit hit{1, sphere.center + sphere.radius * n, d, n, {4, Side::outwards}};
    check_same(table().mirror_bounce(hit, 0.5).ray, oracle().mirror_bounce(hit, 0.5).ray);
    CHECK(table().schlick(-dot(d, n), 1.5) == within(1e-15, oracle().schlick(-dot(d, n), 1.5)));
    for (const Side side : {Side::outwards, Side::inwards})
      for (const double index : {0.7, 1.5}) {
        const Hit here{1, side == Side::outwards ? hit.point : c - sphere.radius * n, d, n, {4, side}};
        const GlassBounces expected = oracle().glass_bounces(sphere, index, here),
                           got = table().glass_bounces(sphere, index, here);
        CHECK(got.reflected.weight == within(1e-12, expected.reflected.weight));
        CHECK(got.refracted.weight == within(1e-12, expected.refracted.weight));
        check_same(got.reflected.ray, expected.reflected.ray);
        if (expected.refracted.weight > 0.01) check_same(got.refracted.ray, expected.refracted.ray);
      }
    CHECK(table().through_sphere(sphere, 0.7, hit).has_value() == oracle().through_sphere(sphere, 0.7, hit).has_value());
  }
}

TEST_CASE("oracle tasks: counting, comparing and adding", "[oracle]") {
  CHECK(oracle().nearest_hit(std::vector<Candidate>{{0, {}}, {1, 2}, {2, 1}, {3, 1}}) == std::optional<std::size_t>(2));
  CHECK_FALSE(oracle().nearest_hit({}).has_value());
  CHECK(oracle().sum_lights({}) == Color(0));
  CHECK(oracle().sum_lights(std::vector<Color>{Color(1e16), Color(1), Color(-1e16)}) == Color(1));
  CHECK(oracle().blocked(std::vector<Crossing>{{1, true}, {2, false}}, infinity));
  CHECK_FALSE(oracle().blocked(std::vector<Crossing>{{1, true}, {2, false}}, 2));
  CHECK(oracle().go_on(5, 5, 0.1));
  CHECK_FALSE(oracle().go_on(6, 5, 0.1));
  CHECK_FALSE(oracle().go_on(1, 5, 0));
  CHECK(oracle().sample_positions().size() == 4);
  CHECK(oracle().resolve(std::vector<Color>{Color(0, 1, 3), Color(0.5, 1, 0)}) == Color(0.25, 1, 1));
  CHECK(oracle().specular_weight(infinity) == 1);
  CHECK(oracle().mirror_bounce({}, 0.25).weight == 0.25);
}

TEST_CASE("oracle tasks: answers are the nearest doubles, where rounding costs the solution all digits too", "[oracle]") {
  // Half a unit in the last place inside a tangent: t = 5 - sqrt(1 - y^2).
  CHECK(oracle().sphere_hit({{-5, 0x1.fffffffffffffp-1, 0}, {1, 0, 0}, {}}, {{0, 0, 0}, 1}) ==
        std::optional<double>(4.999999985098838806152344));
  CHECK(oracle().sphere_hit({{-5, 1, 0}, {1, 0, 0}, {}}, {{0, 0, 0}, 1}) == std::optional<double>(5));
  CHECK_FALSE(oracle().sphere_hit({{-5, 0x1.0000000000001p+0, 0}, {1, 0, 0}, {}}, {{0, 0, 0}, 1}).has_value());
  // A touch, by a ray whose unit direction no double has; t counts in the direction as it is given.
  CHECK(oracle().sphere_hit({{-9, -17, 0}, {3, 4, 0}, {}}, {{4, -8, 0}, 5}) == std::optional<double>(3));
  CHECK(oracle().sphere_hit({{0, 0, 0}, {0, 0, 1e-200}, {}}, {{0, 0, 3e-200}, 1e-200}) == std::optional<double>(2));
  CHECK(oracle().plane_hit({{0, 8, 0}, {0.6, -0.8, 0}, {}}, {{0, 0, 0}, {0, 1e200, 0}}) == std::optional<double>(10));
  CHECK(oracle().reflect({3, -4, 0}, {0, 1, 0}) == Vec3(3, 4, 0));
  CHECK(oracle().sphere_normal({{0, 0, 0}, 1}, {0, 3e-320, 4e-320}) == within(1e-3, Vec3(0, 0.6, 0.8)));
}

TEST_CASE("oracle tasks: what has no answer throws, or stays no number", "[oracle]") {
  const double nan = std::nan("");
  CHECK_THROWS_AS(oracle().sphere_hit({{0, 0, nan}, {0, 0, 1}, {}}, {{0, 0, 0}, 1}), std::domain_error);
  CHECK_THROWS_AS(oracle().sphere_hit(down_z, {{0, 0, 0}, infinity}), std::domain_error);
  CHECK_THROWS_AS(oracle().sphere_hit({{0, 0, 5}, {0, 0, 0}, {}}, {{0, 0, 0}, 1}), std::domain_error);
  CHECK_THROWS_AS(oracle().sphere_hit({{0, 0, 5}, {0, infinity, 1}, {}}, {{0, 0, 0}, 1}), std::domain_error);
  CHECK_THROWS_AS(oracle().plane_hit(down_z, {{0, 0, 0}, {0, 0, 0}}), std::domain_error);
  CHECK_THROWS_AS(oracle().plane_hit(down_z, {{0, -infinity, 0}, {0, 1, 0}}), std::domain_error);
  CHECK_THROWS_AS(oracle().nearest_hit(std::vector<Candidate>{{0, nan}, {0, 1}}), std::domain_error);
  CHECK_THROWS_AS(oracle().blocked(std::vector<Crossing>{{1, false}}, nan), std::domain_error);
  CHECK_THROWS_AS(oracle().point_light({{0, nan, 0}, 1}, {}, {0, 1, 0}, {0, 1, 0}, {}), std::domain_error);
  CHECK_THROWS_AS(oracle().blinn_phong({0, 1, 0}, {0, 1, 0}, {0, 1, 0}, 1, Color(1), nan), std::domain_error);
  CHECK_THROWS_AS(oracle().blinn_phong({0, 1, 0}, {0, 1, 0}, {0, 1, 0}, 1, Color(1), 1e101), std::domain_error);
  CHECK_THROWS_AS(oracle().camera_ray({{}, {0, 0, -1}, {0, 1, 0}, 1e300}, 4, 4, 0, 0, 0, 0), std::domain_error);
  CHECK_THROWS_AS(oracle().through_sphere({}, nan, {0, {}, {0, 0, -1}, {0, 0, 1}, {}}), std::domain_error);
  CHECK(std::isnan(oracle().resolve(std::vector<Color>{Color(nan, 0, 0), Color(1)}).r));
  CHECK(std::isnan(oracle().resolve({}).r));
  CHECK(std::isnan(oracle().sum_lights(std::vector<Color>{Color(infinity), Color(-infinity)}).r));
  CHECK(std::isnan(oracle().sphere_normal({{1, 2, 3}, 1}, {1, 2, 3}).x));
  CHECK(std::isnan(oracle().schlick(nan, 1.5)));
  CHECK(std::isnan(oracle().specular_weight(nan)));
  CHECK(std::isnan(oracle().camera_ray({{}, {0, 0, 0}, {0, 1, 0}, 45}, 4, 4, 0, 0, 0, 0).direction.x));
}

TEST_CASE("oracle tasks: a faint shininess keeps its digits", "[oracle]") {
  for (const double shininess : {1e-70, 4e-151, 1e-300}) CHECK(oracle().specular_weight(shininess) == shininess / 400);
}
