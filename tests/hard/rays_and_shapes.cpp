// The hard cases of stages 1 and 2.

#include "tests/hard/case.hpp"

namespace raylab::test::hard {
namespace {

using nlohmann::json;

// Stage 1

void camera_dir(const Case& c) {
  const json& decimal = c.data["inputs_dec"];
  if (c.tolerance_class() == "reject") {
    CHECK(refused("", "position = [0,0,0]\nfacing = " + toml(decimal["f"]) + "\nup = " + toml(decimal["u"]) + "\n"));
    return;
  }
  const Camera camera{{0, 0, 0}, c.input_vector("f"), c.input_vector("u"), std::atan(c.input("tan")) * 180 / pi};
  const Ray ray = c.table().camera_ray(camera, static_cast<int>(c.input("w")), static_cast<int>(c.input("h")),
                                       c.input("X") + 0.5, c.input("Y") + 0.5, 0, 0);
  check_vector(c, ray.direction, c.expected_vector("dir"));
}

void accumulate(const Case& c) {
  // The step is the pixel size of an image that is 2 tan(theta) wide: the offset is (i + 1/2 - W/2) of them.
  const int width = static_cast<int>(c.input("n")) + 1;
  const double theta = std::atan(c.input("step") * width / 2) * 180 / pi;
  const Camera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, theta};
  const Vec3 d = c.table().camera_ray(camera, width, 1, c.input("start") + c.input("n") + 0.5, 0.5, 0, 0).direction;
  check_value(c, d.x / -d.z, c.expected("offset"));
}

void field_of_view(const Case& c) {
  const Camera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, c.input("theta")};
  const Vec3 d =
      c.table().camera_ray(camera, static_cast<int>(c.input("w")), static_cast<int>(c.input("h")), 1, 1, 0, 0).direction;
  check_value(c, d.x / -d.z, c.expected("slope"));
}

void half_right_angle(const Case& c) {
  const std::string theta = text(c.input("theta64") * 180 / pi);  // 90 degrees, but for rounding
  CHECK(refused("half_field_of_view = 90\n"));
  CHECK(refused("half_field_of_view = " + theta + "\n"));
}

// Stage 2

void plane(const Case& c) {
  const Vec3 o = c.input_vector("o"), n = c.input_vector("n");
  const bool segment = c.data["op"] == "segment_plane";
  const Vec3 d = segment ? c.input_vector("p2") - o : c.input_vector("d");
  if (c.tolerance_class() == "reject") {
    CHECK(refused("[[plane]]\npoint = [0,0,0]\ncolor = [1,1,1]\nnormal = " + toml(c.data["inputs_dec"]["n"]) + "\n"));
    return;
  }
  const std::optional<double> t = c.table().plane_hit({o, unit(d), {}}, {c.input_vector("c"), n});
  if (c.expected_kind() == "miss") {
    CHECK(t == miss);
  } else if (c.id() == "I03") {
    if (t) CHECK(std::isfinite(*t));  // model: hit or miss
  } else {
    REQUIRE(t.has_value());
    const double s = *t / length(d), expected = c.expected("s");
    INFO("got " << text(s));
    CHECK(std::abs(s - expected) <= std::max(c.tolerance(), 4 * c.u()) * std::abs(expected));
  }
}

void sphere_t(const Case& c) {
  const json& decimal = c.data["inputs_dec"];
  const std::string wanted = c.expected_kind(), id = c.id();
  if (wanted == "reject") {
    for (const char* radius : {"0.0", "-1.0", "nan"})
      CHECK(refused(std::string("[[sphere]]\ncenter = [0,0,0]\ncolor = [1,1,1]\nradius = ") + radius + "\n"));
    return;
  }
  if (id == "I30" || id == "I35") {  // beyond the range that a scene may have
    CHECK(
        refused("[[sphere]]\ncolor = [1,1,1]\ncenter = " + toml(decimal["o"]) + "\nradius = " + toml(decimal["r"]) + "\n"));
    return;
  }
  const Vec3 d = c.input_vector("d");
  const Ray ray{c.input_vector("o"), d == Vec3(0) ? d : unit(d), {}};
  const std::optional<double> t = c.table().sphere_hit(ray, {c.input_vector("c"), c.input("r")});
  if (id == "I14") {  // either answer
    CHECK(t == c.table().sphere_hit(ray, {c.input_vector("c"), c.input("r")}));
  } else if (id == "I33") {  // a zero direction cannot arise: anything but NaN
    CHECK_FALSE((t && std::isnan(*t)));
  } else if (wanted == "miss") {
    CHECK(t == miss);
  } else if (wanted == "roots") {
    CHECK_FALSE((t && std::isnan(*t)));  // I25: the driver never asks about the sphere that a ray leaves; see driver.cpp
  } else {
    REQUIRE(t.has_value());
    if (c.tolerance_class() != "class")
      check_value(c, *t / length(scaled(d)) / (length(d) / length(scaled(d))), c.expected("t"));
  }
}

void sphere_normal(const Case& c) {
  const Vec3 d = c.input_vector("d"), o = c.input_vector("o");
  const Sphere sphere{c.input_vector("c"), c.input("r")};
  const std::optional<double> t = c.table().sphere_hit({o, unit(d), {}}, sphere);
  REQUIRE(t.has_value());
  check_vector(c, c.table().sphere_normal(sphere, o + *t * unit(d)), c.expected_vector("n"));
}

void touching_sample(const Case& c) {  // A09
  const std::optional<double> t =
      c.table().sphere_hit({c.input_vector("o"), c.input_vector("d"), {}}, {c.input_vector("c"), c.input("r")});
  CHECK(t == within(0, c.expected("t")));
}

void tie(const Case& c) {
  if (c.id() == "A09") return touching_sample(c);
  const std::optional<double> t =
      c.table().sphere_hit({c.input_vector("o"), c.input_vector("d"), {}}, {c.input_vector("c"), c.input("r")});
  const std::vector<Candidate> twins{{0, t}, {1, t}};
  CHECK(c.table().nearest_hit(twins) == std::optional<std::size_t>(0));
}

}  // namespace

Tests tests_of_rays_and_shapes() {
  return {
      {"camera_dir", camera_dir},
      {"pixel_offsets", elsewhere},  // driver.cpp: "pixels have the handout's coordinates"
      {"pixel_offset_exact", [](const Case&) { CHECK(refused("[image]\nwidth = 33554433\n")); }},  // 65536 at most
      {"accumulate", accumulate},
      {"tan", half_right_angle},
      {"field_of_view", field_of_view},
      {"segment_plane", plane},
      {"plane_s", plane},
      {"sphere_t", sphere_t},
      {"segment_sphere", elsewhere},  // model: does not apply, rays have no far end
      {"sphere_normal", sphere_normal},
      {"tie", tie},
  };
}

}  // namespace raylab::test::hard
