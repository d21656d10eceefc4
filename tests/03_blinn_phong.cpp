#include "tests/right_or_own.hpp"

#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

const Vec3 up(0, 1, 0);
const Color copper(0.8, 0.4, 0.2);

/// How large a number would have to be, of which a rounding spoils as much as the highlight of this shininess has of H.N's:
/// the power multiplies what H.N is wrong by with alpha. H.N has few roundings, at most 8, and 64 are allowed.
double highlight_size(double alpha) { return std::isinf(alpha) ? 1 : std::max(1.0, alpha / 8); }

/// What 3.2 makes of the cosine L.N > 0, of H.N and of k_s by 3.1; of a light below the surface, of the cosine 0.
auto lit(double tolerance, double cosine, double h_n, double alpha, const Color& color, double size) {
  return right_or_own([=](const StageTable& asked) {
    const double power = std::isinf(alpha) ? 0 : std::pow(h_n, alpha);
    return within(tolerance, (cosine + asked.specular_weight(alpha) * power) * color, size);
  });
}
auto lit(double tolerance, double cosine, double h_n, double alpha, const Color& color) {
  return lit(tolerance, cosine, h_n, alpha, color, highlight_size(alpha));
}

/// What 3.3 and 3.4 make of 3.2, on copper whose normal is `up`.
auto copper_lit(double tolerance, const Vec3& l, const Vec3& v, double intensity, double shininess, double size) {
  return right_or_own([=](const StageTable& asked) {
    return within(tolerance, asked.blinn_phong(l, up, v, intensity, copper, shininess), size);
  });
}
auto copper_lit(double tolerance, const Vec3& l, const Vec3& v, double intensity, double shininess) {
  return copper_lit(tolerance, l, v, intensity, shininess, highlight_size(shininess));
}

Material copper_of(double shininess) { return {copper, shininess, false, 1.5}; }

}  // namespace

TEST_CASE("3.1 specular_weight: is 0 for matte, 1 for a perfect mirror", "[stage3][3.1]") {
  CHECK(table().specular_weight(0) == within(0, 0.0));
  CHECK(table().specular_weight(infinity) == within(0, 1.0));
}

TEST_CASE("3.1 specular_weight: is the handout's formula", "[stage3][3.1]") {
  for (const double alpha : {1.0, 10.0, 100.0, 200.0, 1000.0, 5000.0})
    CHECK(table().specular_weight(alpha) == within(1e-15, printed_tasks().specular_weight(alpha)));
}

TEST_CASE("3.1 specular_weight: grows with shininess and stays within 0 to 1", "[stage3][3.1]") {
  double last = 0;
  for (double alpha = 0.001; alpha < 1e6; alpha *= 1.5) {
    const double k_s = table().specular_weight(alpha);
    CHECK(k_s >= last - allowed(0));
    CHECK(k_s <= 1 + allowed(0));
    last = k_s;
  }
}

TEST_CASE("3.2 blinn_phong: a matte surface shows the cosine", "[stage3][3.2]") {
  for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
    const double angle = degrees * pi / 180;
    const Vec3 l(std::sin(angle), std::cos(angle), 0);
    CHECK(table().blinn_phong(l, up, up, 2, copper, 0) == lit(1e-15, std::cos(angle), 1, 0, 2.0 * copper));
  }
}

TEST_CASE("3.2 blinn_phong: light and viewer along the normal give the full highlight", "[stage3][3.2]") {
  CHECK(table().blinn_phong(up, up, up, 1, copper, 1000) == lit(1e-15, 1, 1, 1000, copper));
}

TEST_CASE("3.2 blinn_phong: the highlight follows the half vector", "[stage3][3.2]") {
  // The viewer at 60 degrees on one side and the light at 20 on the other: H leans 20 degrees to the viewer.
  const auto at = [](double degrees) { return Vec3(std::sin(degrees * pi / 180), std::cos(degrees * pi / 180), 0); };
  for (const double alpha : {5.0, 50.0, 400.0}) {
    CHECK(table().blinn_phong(at(-20), up, at(60), 1, Color(1), alpha) ==
          lit(1e-13, std::cos(20 * pi / 180), std::cos(20 * pi / 180), alpha, Color(1)));
    // Where neither L nor V leans as far as H does.
    CHECK(table().blinn_phong(at(50), up, at(-20), 1, Color(1), alpha) ==
          lit(1e-13, std::cos(50 * pi / 180), std::cos(15 * pi / 180), alpha, Color(1)));
  }
}

TEST_CASE("3.2 blinn_phong: is the same with light and viewer exchanged, but for the diffuse part", "[stage3][3.2]") {
  Random random(8);
  for (int k = 0; k < 300; ++k) {
    const Vec3 n = random.direction(), l = -random.arriving_at(n), v = -random.arriving_at(n);
    const double alpha = random.between(1, 300);
    const Color there = table().blinn_phong(l, n, v, 1, copper, alpha) - dot(l, n) * copper;
    const Color back = table().blinn_phong(v, n, l, 1, copper, alpha) - dot(v, n) * copper;
    // H is L + V divided by its length: the shorter that is, the more is it wrong by.
    const double size = highlight_size(alpha) / std::min(1.0, length(l + v));
    CHECK(there == within(1e-13, back, size));
    CHECK(there == lit(1e-12, 0, dot(unit(l + v), n), alpha, copper, size));
  }
}

TEST_CASE("3.2 blinn_phong: a light below the surface gives no diffuse light", "[stage3][3.2]") {
  CHECK(table().blinn_phong(-up, up, up, 1, copper, 50) == Color(0));
  CHECK(table().blinn_phong(unit(Vec3(1, -2, 0)), up, unit(Vec3(1, 1, 0)), 1, copper, 50) == Color(0));
  const Vec3 below = unit(Vec3(1, -0.2, 0));
  for (const double alpha : {0.0, 5.0}) {
    const Color some = table().blinn_phong(below, up, up, 1, copper, alpha);
    // H.N > 0 all the same, and clamping each dot product by itself leaves a highlight: an accepted variant (D9).
    if (!judging_submission()) CHECK(some == Color(0));
    if (some != Color(0)) CHECK(some == lit(1e-13, 0, dot(unit(below + up), up), alpha, copper));
  }
}

TEST_CASE("3.2 blinn_phong: a light opposite the viewer is black, not undefined", "[stage3][3.2]") {
  CHECK(table().blinn_phong({0, 0, -1}, up, {0, 0, 1}, 1, copper, 1000) == Color(0));
}

TEST_CASE("3.2 blinn_phong: a perfect mirror has no highlight, and a matte surface none", "[stage3][3.2]") {
  CHECK(table().blinn_phong(up, up, up, 1, copper, infinity) == lit(1e-15, 1, 1, infinity, copper));
  CHECK(table().blinn_phong(up, up, unit(Vec3(1, 1, 1)), 1, copper, infinity) == lit(1e-15, 1, 0, infinity, copper));
  CHECK(table().blinn_phong(up, up, up, 1, copper, 0) == lit(1e-15, 1, 1, 0, copper));
}

TEST_CASE("3.2 blinn_phong: is proportional to intensity and color, and not clamped", "[stage3][3.2]") {
  CHECK(table().blinn_phong(up, up, up, 10, copper, 0) == lit(1e-14, 1, 1, 0, 10.0 * copper));
  CHECK(table().blinn_phong(up, up, up, 0, copper, 100) == Color(0));
}

TEST_CASE("3.3 point_light: weakens with one plus the distance, squared", "[stage3][3.3]") {
  for (const double r : {0.001, 1.0, 3.0, 99.0})
    CHECK(table().point_light({{5, 1 + r, 0}, 8}, {5, 1, 0}, up, up, copper_of(0)) ==
          copper_lit(1e-14, up, up, 8 / ((1 + r) * (1 + r)), 0, 0));
}

TEST_CASE("3.3 point_light: shines along the unit vector to the light", "[stage3][3.3]") {
  // 3-4-5: the cosine is 4/5, the distance 5.
  CHECK(table().point_light({{3, 4, 0}, 36}, {0, 0, 0}, up, up, copper_of(0)) == copper_lit(1e-15, {0.6, 0.8, 0}, up, 1, 0));
}

TEST_CASE("3.3 point_light: is black below the surface, and where the light is at the point itself", "[stage3][3.3]") {
  CHECK(table().point_light({{0, -1, 0}, 5}, {0, 0, 0}, up, up, copper_of(0)) == copper_lit(0, -up, up, 1.25, 0));
  const Color at_the_light = table().point_light({{1, 2, 3}, 5}, {1, 2, 3}, up, up, copper_of(100));
  // Some leave it to 3.2 to say so, of the direction 0 or 0/0.
  const Vec3 l = is_finite(at_the_light) ? Vec3(0) : Vec3(std::nan(""));
  CHECK(at_the_light == copper_lit(0, l, up, 5, 100));
}

TEST_CASE("3.3 point_light: has the highlight of its material's shininess", "[stage3][3.3]") {
  CHECK(table().point_light({{0, 1, 0}, 4}, {0, 0, 0}, up, up, copper_of(300)) == copper_lit(1e-15, up, up, 1, 300));
}

TEST_CASE("3.3 point_light: the highlight stands where the viewer sees the light mirrored", "[stage3][3.3]") {
  // Light and viewer lean by the same angle to either side of the normal, so that H = N.
  CHECK(table().point_light({{0.6, 0.8, 0}, 4}, {0, 0, 0}, up, {-0.6, 0.8, 0}, copper_of(300)) ==
        copper_lit(1e-12, {0.6, 0.8, 0}, {-0.6, 0.8, 0}, 1, 300));
}

namespace {

void check_directions(std::initializer_list<double> sizes) {
  for (const double size : sizes) {
    CHECK(table().directional_light({{0, -size, 0}, 0.5}, up, up, copper_of(0)) == copper_lit(1e-15, up, up, 0.5, 0));
    CHECK(table().directional_light({{3 * size, -4 * size, 0}, 1}, up, up, copper_of(0)) ==
          copper_lit(1e-15, {-0.6, 0.8, 0}, up, 1, 0));
    CHECK(table().directional_light({{0, size, 0}, 0.5}, up, up, copper_of(0)) == copper_lit(0, -up, up, 0.5, 0));
  }
}

}  // namespace

TEST_CASE("3.4 directional_light: travels along its direction, of any length, and does not weaken", "[stage3][3.4]") {
  check_directions({0.01, 1, 25, 1000});
}

TEST_CASE("3.4 directional_light: the direction may be 1e-150 or 1e200 long", "[stage3][3.4][hard]") {
  check_directions({1e-150, 1e200});
}

TEST_CASE("3.4 directional_light: has the highlight of its material's shininess", "[stage3][3.4]") {
  CHECK(table().directional_light({{0, -2, 0}, 0.5}, up, up, copper_of(300)) == copper_lit(1e-15, up, up, 0.5, 300));
}

TEST_CASE("3.4 directional_light: the highlight stands where the viewer sees the light mirrored", "[stage3][3.4]") {
  CHECK(table().directional_light({{-3, -4, 0}, 0.5}, up, {-0.6, 0.8, 0}, copper_of(300)) ==
        copper_lit(1e-12, {0.6, 0.8, 0}, {-0.6, 0.8, 0}, 0.5, 300));
}

TEST_CASE("3.5 ambient_light: is intensity times color, whatever the shininess", "[stage3][3.5]") {
  CHECK(table().ambient_light({0.1}, copper_of(0)) == within(1e-16, 0.1 * copper));
  CHECK(table().ambient_light({0.1}, copper_of(1000)) == within(1e-16, 0.1 * copper));
  CHECK(table().ambient_light({3}, copper_of(infinity)) == within(1e-15, 3.0 * copper));
}

TEST_CASE("3.6 sum_lights: adds all, clamps nothing, and is black for none", "[stage3][3.6]") {
  CHECK(table().sum_lights({}) == Color(0));
  const std::vector<Color> lights{{0.5, 0.25, 0}, {0.75, 0, 0}, {2, 0.5, 0.125}};
  CHECK(table().sum_lights(lights) == within(1e-15, Color(3.25, 0.75, 0.125)));
}
