// The field lists of the plain structs that tasks take and return: what prints, compares and records calls relies on them.

#include "core/math/camera.hpp"
#include "core/math/hit.hpp"
#include "core/math/lights.hpp"
#include "core/math/material.hpp"
#include "core/math/sample.hpp"
#include "core/math/seen.hpp"
#include "core/math/shapes.hpp"
#include "tests/catch.hpp"

#include <cstddef>
#include <string>

using namespace raylab;

namespace {

/// The names in a struct's list; fails if the fields leave room in it for one more that the list forgets.
template <class Struct>
std::string fields() {
  const Struct object{};
  std::string names;
  std::size_t bytes = 0;
  for_each_field(object, [&](const Field& field, const auto& value) {
    names += std::string(names.empty() ? "" : " ") + field.name;
    bytes += sizeof value;
  });
  CHECK(sizeof(Struct) - bytes < alignof(Struct));
  return names;
}

}  // namespace

TEST_CASE("fields: each plain struct lists all its fields in order", "[math]") {
  CHECK(fields<Leaves>() == "geometry side");
  CHECK(fields<Ray>() == "origin direction leaves");
  CHECK(fields<Camera>() == "position facing up half_field_of_view");
  CHECK(fields<Plane>() == "point normal");
  CHECK(fields<Sphere>() == "center radius");
  CHECK(fields<Material>() == "color shininess transparent refractive_index");
  CHECK(fields<PointLight>() == "position intensity");
  CHECK(fields<DirectionalLight>() == "direction intensity");
  CHECK(fields<AmbientLight>() == "intensity");
  CHECK(fields<Candidate>() == "geometry t");
  CHECK(fields<Hit>() == "t point direction normal leaves");
  CHECK(fields<Crossing>() == "t transparent");
  CHECK(fields<Bounce>() == "ray weight");
  CHECK(fields<GlassBounces>() == "reflected refracted");
  CHECK(fields<SampleOffset>() == "dx dy");
  CHECK(fields<Seen>() == "color ray t background bounce");
}

TEST_CASE("fields: those of a variable can be set, and say whether they may be left out", "[math]") {
  Sphere sphere;
  for_each_field(sphere, [](const Field&, auto& value) { value = {}; });
  CHECK(sphere.radius == 0);
  std::string optional;
  for_each_field(Leaves{}, [&](const Field& field, const auto&) { optional += field.optional ? field.name : "-"; });
  CHECK(optional == "-side");
}

TEST_CASE("fields: an enum lists the names of its values", "[math]") {
  std::string names;
  for_each_name(Side{}, [&](const char* name, Side value) { names += value == Side::inwards ? name : "-"; });
  CHECK(names == "-inwards");
}
