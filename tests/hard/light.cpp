// The hard cases of stages 3 and 4.

#include "tests/hard/case.hpp"

namespace raylab::test::hard {
namespace {

using nlohmann::json;

// Stage 3

/// The specular term by itself, k_s taken off: what is left of a white surface without its diffuse part.
double specular_of(const Case& c, const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  const double all = c.table().blinn_phong(l, n, v, 1, Color(1), alpha).r;
  return all == 0 ? 0 : (all - dot(l, n)) / c.table().specular_weight(alpha);
}

void specular(const Case& c) {
  const Vec3 l = unit(c.input_vector("L")), v = unit(c.input_vector("V")), n = unit(c.input_vector("N"));
  const double actual = specular_of(c, l, n, v, c.input("alpha"));
  const double expected = c.id() == "B03" || c.id() == "B07" ? 0 : c.expected("specular");
  if (c.id() == "B03") {  // an accepted variant clamps each dot product by itself
    CHECK((actual == 0 || std::abs(actual * c.table().specular_weight(10) -
                                   c.expected("specular") * c.table().specular_weight(10)) < 1e-15));
    return;
  }
  INFO("got " << text(actual) << ", wanted " << text(expected));
  CHECK(std::abs(actual - expected) <= std::max(c.tolerance(), 8 * c.u()));
}

void power(const Case& c) {
  // H at an angle whose cosine is x from N, as exactly as doubles can say it.
  const double x = c.input("x"), alpha = c.input("alpha");
  const Vec3 h(std::sqrt((1 - x) * (1 + x)), x, 0), n(0, 1, 0);
  if (x < 0) {
    CHECK(specular_of(c, n, n, h, alpha) == within(1e-15, 0.0));
    return;
  }
  check_value(c, specular_of(c, h, n, h, alpha), c.expected("pow"));
}

void weight(const Case& c) {
  if (c.tolerance_class() == "reject") {
    for (const char* alpha : {"-1.0", "nan"})
      CHECK(refused(std::string("[[plane]]\npoint=[0,0,0]\nnormal=[0,1,0]\ncolor=[1,1,1]\nshininess = ") + alpha + "\n"));
    return;
  }
  const double alpha = c.input("alpha"), expected = c.expected("k_s");
  INFO("got " << text(c.table().specular_weight(alpha)));
  CHECK(std::abs(c.table().specular_weight(alpha) - expected) <= 5 * c.u() * expected);  // 2.5 ulp, as its bound says
  if (alpha == 0)  // B06: 0^0 is 1, and its product with k_s is 0
    CHECK(c.table().blinn_phong({0, 1, 0}, {0, 1, 0}, {1, 0, 0}, 1, Color(1), alpha) == Color(1));
}

void light_at_point(const Case& c) {
  const Color at_point = c.table().point_light({c.input_vector("light"), c.input("I")}, c.input_vector("p"), {0, 1, 0},
                                               {0, 1, 0}, {Color(1), 100, false, 1.5});
  CHECK(at_point == Color(0));
}

void lit_plane_from_behind(const Case& c) {
  // The driver turns the normal to the viewer: task 3.2 is asked with it.
  const Vec3 v = c.input_vector("V"), turned = dot(c.input_vector("N"), v) < 0 ? -c.input_vector("N") : c.input_vector("N");
  CHECK(c.table().blinn_phong(c.input_vector("L"), turned, v, 1, Color(1), 0) == Color(1));
}

void direction_of_light(const Case& c) {
  if (c.tolerance_class() == "reject") {
    CHECK(refused("[[directional_light]]\ndirection = [0,0,0]\nintensity = 1\n"));
  } else if (c.id() == "B14") {
    CHECK(c.table().directional_light({c.input_vector("v"), 1}, {0, 1, 0}, {0, 1, 0}, {Color(1), 0, false, 1.5}) ==
          Color(1));
  } else {  // B02: a light that is 2^-600 away still has a direction
    const Vec3 to_light = c.input_vector("v");
    CHECK(c.table().point_light({to_light, 1}, {0, 0, 0}, c.expected_vector("L"), c.expected_vector("L"),
                                {Color(1), 0, false, 1.5}) == Color(1));
  }
}

void attenuation(const Case& c) {
  const double r = c.input("r");
  CHECK(refused("[[point_light]]\nintensity = 1\nposition = [" + text(r) + ",0,0]\n"));
}

// Stage 4

void shadow(const Case& c) {
  const json& in = c.data["inputs"];
  const Vec3 p = c.input_vector("p");
  if (in.contains("self_r")) {
    // S07, S08: a light below the surface of the point's own sphere is dark without being asked about.
    const Vec3 n = c.input_vector("N");
    const Vec3 l = unit(in.contains("light") ? c.input_vector("light") - p : c.input_vector("Lray"));
    CHECK(dot(l, n) < 0);
    CHECK(c.table().blinn_phong(l, n, n, 1, Color(1), 0) == Color(0));
    return;
  }
  const Vec3 light = c.input_vector("light");
  const Ray ray{p, unit(light - p), {}};
  const std::optional<double> t = c.table().sphere_hit(ray, {c.input_vector("blocker_c"), c.input("blocker_r")});
  std::vector<Crossing> crossings;
  if (t) crossings.push_back({*t, in.value("blocker_transparent", false)});
  const std::string truth = c.data["expected"]["true"];
  CHECK(c.table().blocked(crossings, length(light - p)) == (truth.substr(0, 7) == "blocked"));
}

}  // namespace

Tests tests_of_light() {
  return {
      {"specular", specular},
      {"ks_spec", weight},
      {"pow", power},
      {"ks", weight},
      {"product", [](const Case&) { CHECK(refused("[[ambient_light]]\nintensity = inf\n")); }},
      {"blinn_phong", [](const Case& c) { c.id() == "B01" ? light_at_point(c) : lit_plane_from_behind(c); }},
      {"normalize", direction_of_light},
      {"attenuation", attenuation},
      {"shadow", shadow},
  };
}

}  // namespace raylab::test::hard
