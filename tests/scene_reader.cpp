#include "core/scene/read_scene.hpp"

#include "tests/catch.hpp"
#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using namespace raylab;
using raylab::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

using Messages = std::vector<std::string>;

/// The first line of most scenes here, so that what a test is about begins in line 2.
const std::string camera = "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0]}\n";

Messages messages(const SceneFile& file) {
  Messages result;
  for (const Diagnostic& diagnostic : file.diagnostics) result.push_back(to_string(diagnostic));
  return result;
}

Scene good(const std::string& toml) {
  const SceneFile file = parse_scene(toml, "scene.toml");
  INFO(toml);
  CHECK(messages(file) == Messages{});
  REQUIRE(file.scene.has_value());
  return *file.scene;
}

Messages warnings(const std::string& toml) {
  const SceneFile file = parse_scene(toml, "scene.toml");
  INFO(toml);
  CHECK(file.scene.has_value());
  for (const Diagnostic& diagnostic : file.diagnostics) CHECK(diagnostic.severity == Diagnostic::Severity::warning);
  return messages(file);
}

std::string sphere(const std::string& center, const std::string& radius, const std::string& more = "") {
  return "[[sphere]]\ncenter = " + center + "\nradius = " + radius + "\ncolor = [1, 1, 1]\n" + more;
}

struct BadScene {
  std::string what;
  std::string toml;
  Messages messages;
};

const std::vector<BadScene> bad_scenes{
    {"a camera is required",
     "max_bounces = 3\n",
     {"scene.toml:1:1: camera: missing, write a table [camera] with position, facing and up"}},
    {"an empty text lacks a camera",
     "",
     {"scene.toml:1:1: camera: missing, write a table [camera] with position, facing and up"}},
    {"a camera needs position, facing and up",
     "[camera]\n",
     {"scene.toml:1:1: camera.position: missing, must be a list of 3 numbers",
      "scene.toml:1:1: camera.facing: missing, must be a list of 3 numbers",
      "scene.toml:1:1: camera.up: missing, must be a list of 3 numbers"}},
    {"a camera is a table", "camera = 3\n", {"scene.toml:1:10: camera: must be one table, written [camera], got 3"}},
    {"a camera is one table",
     "[[camera]]\n"
     "position = [0, 0, 0]\n",
     {"scene.toml:1:1: camera: must be one table, written [camera], got a list of 1"}},
    {"a camera position is a list",
     "[camera]\n"
     "position = 1\n"
     "facing = [0, 0, -1]\n"
     "up = [0, 1, 0]\n",
     {"scene.toml:2:12: camera.position: must be a list of 3 numbers, got 1"}},
    {"facing has a length",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0.0, -0.0]\n"
     "up = [0, 1, 0]\n",
     {"scene.toml:3:10: camera.facing: must not be [0, 0, 0]: a direction has a length"}},
    {"up has a length",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "up = [0, 0, 0]\n",
     {"scene.toml:4:6: camera.up: must not be [0, 0, 0]: a direction has a length"}},
    {"up is not parallel to facing",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "  up = [0, 0, -7]\n",
     {"scene.toml:4:8: camera.up: must not be parallel to facing, nor opposite to it"}},
    {"up is not opposite to facing",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [1, 2, 3]\n"
     "up = [-1, -2, -3]\n",
     {"scene.toml:4:6: camera.up: must not be parallel to facing, nor opposite to it"}},
    {"parallel, though squares underflow",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [5e-324, 0, 0]\n"
     "up = [1.7e308, 0, 0]\n",
     {"scene.toml:4:6: camera.up: must not be parallel to facing, nor opposite to it"}},
    {"parallel, though squares overflow",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [1e308, 1e308, 0]\n"
     "up = [1e-300, 1e-300, 0]\n",
     {"scene.toml:4:6: camera.up: must not be parallel to facing, nor opposite to it"}},
    {"parallel up to 1e-12",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "up = [0, 9e-13, 1]\n",
     {"scene.toml:4:6: camera.up: must not be parallel to facing, nor opposite to it"}},
    {"a missing up gives no second message",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 1, 0]\n",
     {"scene.toml:1:1: camera.up: missing, must be a list of 3 numbers"}},
    {"a field of view of 90",
     "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0], half_field_of_view = 90}\n",
     {"scene.toml:1:91: camera.half_field_of_view: must be greater than 0 and less than 90, got 90"}},
    {"a field of view of 0",
     "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0], half_field_of_view = 0}\n",
     {"scene.toml:1:91: camera.half_field_of_view: must be greater than 0 and less than 90, got 0"}},
    {"a field of view of nan",
     "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0], half_field_of_view = nan}\n",
     {"scene.toml:1:91: camera.half_field_of_view: must be a finite number, got nan"}},
    {"camera coordinates end at 1e100",
     "[camera]\n"
     "position = [0, -1.0001e100, 0]\n"
     "facing = [0, 0, -1]\n"
     "up = [0, 1, 0]\n",
     {"scene.toml:2:16: camera.position[1]: must be between -1e100 and 1e100, got -1.0001e100"}},
    {"a title is a string", camera + "title = 3\n", {"scene.toml:2:9: title: must be a string, got 3"}},
    {"a title is one line",
     camera + "title = \"a\\n"
              "b\"\n",
     {"scene.toml:2:9: title: must be one line without control characters, got 'a\\x0ab'"}},
    {"a title holds no control characters",
     camera + "title = \"a\\u0007\"\n",
     {"scene.toml:2:9: title: must be one line without control characters, got 'a\\x07'"}},
    {"max_bounces is whole",
     camera + "max_bounces = 2.5\n",
     {"scene.toml:2:15: max_bounces: must be a whole number, got 2.5"}},
    {"max_bounces has no decimal point",
     camera + "max_bounces = 2.0\n",
     {"scene.toml:2:15: max_bounces: must be a whole number, got 2.0"}},
    {"max_bounces is at least 0",
     camera + "max_bounces = -1\n",
     {"scene.toml:2:15: max_bounces: must be between 0 and 100, got -1"}},
    {"max_bounces is at most 100",
     camera + "max_bounces = 101\n",
     {"scene.toml:2:15: max_bounces: must be between 0 and 100, got 101"}},
    {"max_bounces is no boolean",
     camera + "max_bounces = true\n",
     {"scene.toml:2:15: max_bounces: must be a whole number, got true"}},
    {"a background is a list of 3",
     camera + "background = [0, 0]\n",
     {"scene.toml:2:14: background: must be a list of 3 numbers, got a list of 2"}},
    {"a background has no negative light",
     camera + "background = [0, -0.5, 0]\n",
     {"scene.toml:2:18: background[1]: must be at least 0, got -0.5"}},
    {"a background is finite",
     camera + "background = [0, 0, inf]\n",
     {"scene.toml:2:21: background[2]: must be a finite number, got inf"}},
    {"a width is whole",
     camera + "[image]\n"
              "width = 640.5\n",
     {"scene.toml:3:9: image.width: must be a whole number, got 640.5"}},
    {"a width is written whole",
     camera + "[image]\n"
              "width = 640.0\n",
     {"scene.toml:3:9: image.width: must be a whole number, got 640.0"}},
    {"a width has no exponent",
     camera + "[image]\n"
              "width = 1e3\n",
     {"scene.toml:3:9: image.width: must be a whole number, got 1000.0"}},
    {"a width is at least 1",
     camera + "[image]\n"
              "width = 0\n",
     {"scene.toml:3:9: image.width: must be between 1 and 65536, got 0"}},
    {"a height is at most 65536",
     camera + "[image]\n"
              "height = 65537\n",
     {"scene.toml:3:10: image.height: must be between 1 and 65536, got 65537"}},
    {"a height is no string",
     camera + "[image]\n"
              "height = \"480\"\n",
     {"scene.toml:3:10: image.height: must be a whole number, got a string"}},
    {"an image is a table",
     camera + "image = [640, 480]\n",
     {"scene.toml:2:9: image: must be one table, written [image], got a list of 2"}},
    {"a huge height",
     camera + "[image]\n"
              "height = 9223372036854775807\n",
     {"scene.toml:3:10: image.height: must be between 1 and 65536, got 9223372036854775807"}},
    {"a plane is written in double brackets",
     camera + "[plane]\n"
              "point = [0, 0, 0]\n",
     {"scene.toml:2:1: plane: must be a list of tables, each written [[plane]], got a table"}},
    {"a plane needs its fields",
     camera + "[[plane]]\n",
     {"scene.toml:2:1: plane[0].point: missing, must be a list of 3 numbers",
      "scene.toml:2:1: plane[0].normal: missing, must be a list of 3 numbers",
      "scene.toml:2:1: plane[0].color: missing, must be a list of 3 numbers"}},
    {"a normal has a length",
     camera + "[[plane]]\n"
              "point = [0, 0, 0]\n"
              "normal = [0, 0, 0]\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: plane[0].normal: must not be [0, 0, 0]: a direction has a length"}},
    {"a normal is finite",
     camera + "[[plane]]\n"
              "point = [0, 0, 0]\n"
              "normal = [0, inf, -inf]\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:14: plane[0].normal[1]: must be a finite number, got inf",
      "scene.toml:4:19: plane[0].normal[2]: must be a finite number, got -inf"}},
    {"a plane is not transparent",
     camera + "[[plane]]\n"
              "point = [0, 0, 0]\n"
              "normal = [0, 1, 0]\n"
              "color = [1, 1, 1]\n"
              "transparent = true\n",
     {"scene.toml:6:1: plane[0].transparent: unknown key; known keys: point, normal, color, shininess"}},
    {"a point is at most 1e100",
     camera + "[[plane]]\n"
              "point = [0, 2e100, 0]\n"
              "normal = [0, 1, 0]\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:3:13: plane[0].point[1]: must be between -1e100 and 1e100, got 2e100"}},
    {"a sphere is written in double brackets",
     camera + "[sphere]\n"
              "radius = 1\n",
     {"scene.toml:2:1: sphere: must be a list of tables, each written [[sphere]], got a table"}},
    {"a sphere is no number",
     camera + "sphere = 3\n",
     {"scene.toml:2:10: sphere: must be a list of tables, each written [[sphere]], got 3"}},
    {"a list of spheres holds tables only",
     camera + "sphere = [{center = [0, 0, 0], radius = 1, color = [1, 1, 1]}, 5]\n",
     {"scene.toml:2:64: sphere[1]: must be a table, written [[sphere]], got 5"}},
    {"a sphere needs its fields",
     camera + "[[sphere]]\n",
     {"scene.toml:2:1: sphere[0].center: missing, must be a list of 3 numbers",
      "scene.toml:2:1: sphere[0].radius: missing, must be a number",
      "scene.toml:2:1: sphere[0].color: missing, must be a list of 3 numbers"}},
    {"the second sphere is named so",
     camera + "[[sphere]]\n"
              "center = [0, 0, 0]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "[[sphere]]\n"
              "center = [5, 0, 0]\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:6:1: sphere[1].radius: missing, must be a number"}},
    {"a radius is above 0",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = -1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be greater than 0, got -1"}},
    {"a radius is not 0",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 0\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be greater than 0, got 0"}},
    {"a radius is at least 1e-100",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 9.9e-101\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be between 1e-100 and 1e100, got 9.9e-101"}},
    {"a radius is at most 1e100",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1.1e100\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be between 1e-100 and 1e100, got 1.1e100"}},
    {"a radius is not infinite",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = inf\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be a finite number, got inf"}},
    {"a radius too small for a double is 0",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1e-400\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be greater than 0, got 0.0"}},
    {"a radius is a number",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = \"1\"\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be a number, got a string"}},
    {"a radius is no date",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 2024-01-01\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be a number, got a date or time"}},
    {"a radius is no time",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 12:30:00\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be a number, got a date or time"}},
    {"a radius is no table",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = {}\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:10: sphere[0].radius: must be a number, got a table"}},
    {"a center is a list of 3",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5, 1]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:3:10: sphere[0].center: must be a list of 3 numbers, got a list of 4"}},
    {"a center is no string",
     camera + "[[sphere]]\n"
              "center = \"0, 0, 5\"\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:3:10: sphere[0].center: must be a list of 3 numbers, got a string"}},
    {"a center is no nested list",
     camera + "[[sphere]]\n"
              "center = [[0, 0, 5]]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:3:10: sphere[0].center: must be a list of 3 numbers, got a list of 1"}},
    {"the wrong component is named",
     camera + "[[sphere]]\n"
              "center = [0, \"a\", 5]\n"
              "radius = 1\n"
              "color = [1, true, -0.1]\n",
     {"scene.toml:3:14: sphere[0].center[1]: must be a number, got a string",
      "scene.toml:5:13: sphere[0].color[1]: must be a number, got true",
      "scene.toml:5:19: sphere[0].color[2]: must be at least 0, got -0.1"}},
    {"a list may run over lines",
     camera + "[[sphere]]\n"
              "center = [\n"
              "  0,\n"
              "  nan,\n"
              "  5\n"
              "]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:5:3: sphere[0].center[1]: must be a finite number, got nan"}},
    {"shininess is at least 0",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "shininess = -0.5\n",
     {"scene.toml:6:13: sphere[0].shininess: must be at least 0, got -0.5"}},
    {"shininess is not nan",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "shininess = -nan\n",
     {"scene.toml:6:13: sphere[0].shininess: must be a number, got nan"}},
    {"shininess is not -inf",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "shininess = -inf\n",
     {"scene.toml:6:13: sphere[0].shininess: must be at least 0, got -inf"}},
    {"transparent is a boolean",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "transparent = 1\n",
     {"scene.toml:6:15: sphere[0].transparent: must be true or false, got 1"}},
    {"a refractive index is at least 0.1",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "refractive_index = 0.09\n",
     {"scene.toml:6:20: sphere[0].refractive_index: must be between 0.1 and 10, got 0.09"}},
    {"a refractive index is at most 10",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "refractive_index = 10.5\n",
     {"scene.toml:6:20: sphere[0].refractive_index: must be between 0.1 and 10, got 10.5"}},
    {"a point light is a table in double brackets",
     camera + "[point_light]\n"
              "position = [0, 0, 0]\n"
              "intensity = 1\n",
     {"scene.toml:2:1: point_light: must be a list of tables, each written [[point_light]], got a table"}},
    {"a point light needs its fields",
     camera + "[[point_light]]\n",
     {"scene.toml:2:1: point_light[0].position: missing, must be a list of 3 numbers",
      "scene.toml:2:1: point_light[0].intensity: missing, must be a number"}},
    {"an intensity is at least 0",
     camera + "[[point_light]]\n"
              "position = [0, 0, 0]\n"
              "intensity = -3\n",
     {"scene.toml:4:13: point_light[0].intensity: must be at least 0, got -3"}},
    {"an intensity is finite",
     camera + "[[ambient_light]]\n"
              "intensity = inf\n",
     {"scene.toml:3:13: ambient_light[0].intensity: must be a finite number, got inf"}},
    {"a direction has a length",
     camera + "[[directional_light]]\n"
              "direction = [0, 0, 0]\n"
              "intensity = 1\n",
     {"scene.toml:3:13: directional_light[0].direction: must not be [0, 0, 0]: a direction has a length"}},
    {"an ambient light has no color",
     camera + "[[ambient_light]]\n"
              "intensity = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:4:1: ambient_light[0].color: unknown key; known keys: intensity"}},
    {"an unknown key names the nearest",
     camera + "[[sphere]]\n"
              "center = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n"
              "  colour = [1, 1, 1]\n",
     {"scene.toml:6:3: sphere[0].colour: unknown key, did you mean 'color'?"}},
    {"swapped letters are near",
     camera + "[[sphere]]\n"
              "centre = [0, 0, 5]\n"
              "radius = 1\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:2:1: sphere[0].center: missing, must be a list of 3 numbers",
      "scene.toml:3:1: sphere[0].centre: unknown key, did you mean 'center'?"}},
    {"capitals are near",
     camera + "[[ambient_light]]\n"
              "Intensity = 1\n",
     {"scene.toml:2:1: ambient_light[0].intensity: missing, must be a number",
      "scene.toml:3:1: ambient_light[0].Intensity: unknown key, did you mean 'intensity'?"}},
    {"a key far from all gets the list",
     camera + "[[ambient_light]]\n"
              "intensity = 1\n"
              "brightness_of_it = 2\n",
     {"scene.toml:4:1: ambient_light[0].brightness_of_it: unknown key; known keys: intensity"}},
    {"swapped letters of a short key",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "pu = [0, 1, 0]\n",
     {"scene.toml:1:1: camera.up: missing, must be a list of 3 numbers",
      "scene.toml:4:1: camera.pu: unknown key, did you mean 'up'?"}},
    {"capitals of a short key",
     "[camera]\n"
     "position = [0, 0, 0]\n"
     "facing = [0, 0, -1]\n"
     "UP = [0, 1, 0]\n",
     {"scene.toml:1:1: camera.up: missing, must be a list of 3 numbers",
      "scene.toml:4:1: camera.UP: unknown key, did you mean 'up'?"}},
    {"an unknown key at the top",
     camera + "widht = 3\n",
     {"scene.toml:2:1: widht: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, "
      "sphere_cloud, point_light, directional_light, ambient_light"}},
    {"an unknown table",
     camera + "[[spheres]]\n"
              "radius = 1\n",
     {"scene.toml:2:3: spheres: unknown key, did you mean 'sphere'?"}},
    {"an unknown table below a known one",
     camera + "[image]\n"
              "[image.sizes]\n",
     {"scene.toml:3:8: image.sizes: unknown key; known keys: width, height"}},
    {"an unknown quoted key is shown in one line",
     camera + "\"a\\n"
              "\\u001b\" = 1\n",
     {"scene.toml:2:1: a\\x0a\\x1b: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, "
      "sphere_cloud, point_light, directional_light, ambient_light"}},
    {"a long unknown key is cut",
     camera + std::string(100, 'x') + " = 1\n",
     {"scene.toml:2:1: xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...: unknown key; known keys: title, "
      "max_bounces, background, camera, image, plane, sphere, sphere_cloud, point_light, directional_light, ambient_light"}},
    {"every mistake is reported in one run",
     "max_bounces = 999\n"
     "titel = \"x\"\n"
     "[camera]\n"
     "facing = [0, 0, nan]\n"
     "up = 3\n"
     "[image]\n"
     "width = 1.5\n"
     "height = 0\n"
     "[[plane]]\n"
     "normal = [0, 0, 0]\n"
     "color = [-1, 2, -3]\n"
     "[[sphere]]\n"
     "center = [1, 2]\n"
     "radius = -1\n"
     "color = [1, 1, 1]\n"
     "shine = 3\n"
     "[[point_light]]\n"
     "position = [0, 0, 0]\n"
     "[lights]\n"
     "x = 1\n",
     {"scene.toml:1:15: max_bounces: must be between 0 and 100, got 999",
      "scene.toml:2:1: titel: unknown key, did you mean 'title'?",
      "scene.toml:3:1: camera.position: missing, must be a list of 3 numbers",
      "scene.toml:4:17: camera.facing[2]: must be a finite number, got nan",
      "scene.toml:5:6: camera.up: must be a list of 3 numbers, got 3",
      "scene.toml:7:9: image.width: must be a whole number, got 1.5",
      "scene.toml:8:10: image.height: must be between 1 and 65536, got 0",
      "scene.toml:9:1: plane[0].point: missing, must be a list of 3 numbers",
      "scene.toml:10:10: plane[0].normal: must not be [0, 0, 0]: a direction has a length",
      "scene.toml:11:10: plane[0].color[0]: must be at least 0, got -1",
      "scene.toml:11:17: plane[0].color[2]: must be at least 0, got -3",
      "scene.toml:13:10: sphere[0].center: must be a list of 3 numbers, got a list of 2",
      "scene.toml:14:10: sphere[0].radius: must be greater than 0, got -1",
      "scene.toml:16:1: sphere[0].shine: unknown key; known keys: center, radius, color, shininess, transparent, "
      "refractive_index",
      "scene.toml:17:1: point_light[0].intensity: missing, must be a number",
      "scene.toml:19:2: lights: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, "
      "sphere_cloud, point_light, directional_light, ambient_light"}},
    {"columns count characters",
     camera + "title = 3\n"
              "sphere = [{radius = \"\xc3\xa4\", center = nan, color = [1,1,1]}]\n",
     {"scene.toml:2:9: title: must be a string, got 3", "scene.toml:3:21: sphere[0].radius: must be a number, got a string",
      "scene.toml:3:35: sphere[0].center: must be a list of 3 numbers, got nan"}},
    {"CRLF",
     camera + "max_bounces = -1\r\n"
              "[image]\r\n"
              "width = 0\r\n",
     {"scene.toml:2:15: max_bounces: must be between 0 and 100, got -1",
      "scene.toml:4:9: image.width: must be between 1 and 65536, got 0"}},
    {"a byte order mark",
     "\xef\xbb\xbf"
     "camera = {position = [0, 0, 0], facing = [0, 0, -1], up = [0, 1, 0]}\n"
     "max_bounces = -1\n",
     {"scene.toml:2:15: max_bounces: must be between 0 and 100, got -1"}},
    {"a syntax error ends the list",
     camera + "max_bounces = -1\n"
              "[image\n"
              "width = 0\n",
     {"scene.toml:3:7: not valid TOML (table header): expected ']', saw '\\n'"}},
    {"a text needs quotes",
     camera + "title = hello\n",
     {"scene.toml:2:9: not valid TOML (value): could not determine value type; a text needs quotes"}},
    {"a key stands once",
     camera + "max_bounces = 1\n"
              "max_bounces = 2\n",
     {"scene.toml:3:15: not valid TOML (key-value pair): cannot redefine existing integer 'max_bounces'; write it once"}},
    {"a table stands once",
     camera + "[image]\n"
              "[image]\n",
     {"scene.toml:3:1: not valid TOML (table header): cannot redefine existing table 'image'; write it once"}},
    {"single after double brackets",
     camera + "[[sphere]]\n"
              "[sphere]\n",
     {"scene.toml:3:1: not valid TOML (table header): cannot redefine existing array 'sphere' as table; write [[double "
      "brackets]] each time"}},
    {"a number beyond doubles",
     camera + "[[ambient_light]]\n"
              "intensity = 1e400\n",
     {"scene.toml:3:13: not valid TOML (floating-point): '1e400' could not be interpreted as a value; the largest number is "
      "1.797e308"}},
    {"a whole number beyond 64 bits",
     camera + "[[ambient_light]]\n"
              "intensity = 9223372036854775808\n",
     {"scene.toml:3:13: not valid TOML (decimal integer): '9223372036854775808' is not representable in 64 bits; write so "
      "large a number with an exponent, as in 1e20, up to 1.797e308"}},
    {"a number of 200 digits",
     camera + "[[ambient_light]]\nintensity = 0." + std::string(200, '1') + "\n",
     {"scene.toml:3:13: not valid TOML (floating-point): exceeds length limit of 128 digits (consider using exponent "
      "notation); 17 digits are enough for any number"}},
    {"a decimal comma",
     camera + "[[ambient_light]]\n"
              "intensity = 1,5\n",
     {"scene.toml:3:14: not valid TOML (key-value pair): expected a comment or whitespace, saw ','"}},
    {"an open string",
     camera + "title = \"x\n",
     {"scene.toml:2:11: not valid TOML (string): unescaped control characters other than TAB (U+0009) are explicitly "
      "prohibited"}},
    {"a list without commas",
     camera + "background = [0 0 0]\n",
     {"scene.toml:2:17: not valid TOML (array): expected comma or closing ']', saw '0'"}},
    {"true is small",
     camera + "[[sphere]]\n"
              "transparent = True\n",
     {"scene.toml:3:15: not valid TOML (boolean): expected 'true', saw 'T'; write true; a text needs quotes"}},
    {"a NUL",
     camera + std::string("max_bounces = 1\x00\n", 17),
     {"scene.toml:2:16: a space or a comma is missing before this text"}},
    {"letters beyond ASCII need quotes",
     camera + "gr\xc3\xb6\xc3\x9f"
              "e = 1\n",
     {"scene.toml:2:3: a character that may stand in quotes or behind a # only"}},
    {"a key in quotes next to a letter beyond ASCII",
     camera + "\"a\" = 1\n"
              "\"b\"\xc3\xa4 = 1\n",
     {"scene.toml:3:4: a character that may stand in quotes or behind a # only"}},
    {"control characters stand nowhere",
     camera + "[\x01image]\n",
     {"scene.toml:2:2: a character that may stand in quotes or behind a # only"}},
    {"a text touches a number before it",
     camera + "background = [0\"\xc3\xa4\", 0, 0]\n",
     {"scene.toml:2:17: a space or a comma is missing before this text"}},
    {"a line end is shown in one line",
     camera + "max_bounces = i\n"
              "\n",
     {"scene.toml:2:16: not valid TOML (floating-point): expected 'inf', saw 'i\\x0a'; write inf; a text needs quotes"}},
    {"a long key is cut between characters",
     camera +
         "\"a\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
         "\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
         "\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\" = 1\n",
     {"scene.toml:2:1: "
      "a\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4"
      "\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3\xa4\xc3"
      "\xa4...: unknown key; known keys: title, max_bounces, background, camera, image, plane, sphere, sphere_cloud, "
      "point_light, "
      "directional_light, ambient_light"}},
    {"a text touches a number and a sign before it",
     camera + "background = 6==\"\xc3\xa4\"\n",
     {"scene.toml:2:18: a space or a comma is missing before this text"}},
    {"a text touches a number behind its key",
     camera + "max_bounces=6=\"\xc3\xa4\"\n",
     {"scene.toml:2:16: a space or a comma is missing before this text"}},
    {"a text touches a number and one sign",
     camera + "max_bounces = 6=\"\xc3\xa4\"\n",
     {"scene.toml:2:18: a space or a comma is missing before this text"}},
    {"a backslash before a letter beyond ASCII",
     camera + "title = \"\\\xc3\xa4\"\n",
     {"scene.toml:2:11: a backslash may not stand before this character"}},
    {"a backslash at a line end before a letter beyond ASCII",
     camera + "title = \"\"\"a \\\n"
              "  \xc3\xa4\"\"\"\n",
     {"scene.toml:3:3: a backslash may not stand before this character"}},
    {"a text touches a number that touches its key",
     camera + "max_bounces=6\"\xc3\xa4\"\n",
     {"scene.toml:2:15: a space or a comma is missing before this text"}},
    {"a text touches a number with a bracket",
     camera + "background=[6[=\"\xc3\xa4\"]]\n",
     {"scene.toml:2:17: a space or a comma is missing before this text"}},
    {"a letter beyond ASCII touches a number",
     camera + "max_bounces = 6\xc3\xa4\n",
     {"scene.toml:2:16: a space or a comma is missing before this text"}},
    {"a text touches a sign",
     camera + "background = [-\"\xc3\xa4\", 0, 0]\n",
     {"scene.toml:2:17: a space or a comma is missing before this text"}},
    {"a text may touch a comma behind a number",
     camera + "background=[1,\"\xc3\xa4\",2]\n",
     {"scene.toml:2:15: background[1]: must be a number, got a string"}},
    {"a text may follow a bracket behind a number",
     camera + "background=[[1],\"\xc3\xa4\",2]\n",
     {"scene.toml:2:13: background[0]: must be a number, got a list of 1",
      "scene.toml:2:17: background[1]: must be a number, got a string"}},
    {"a text may follow a space behind a number",
     camera + "image={width = 1 ,height=\"\xc3\xa4\"}\n",
     {"scene.toml:2:26: image.height: must be a whole number, got a string"}},
    {"a text may follow a name that ends in a digit",
     camera + "title1=\"\xc3\xa4\"\n",
     {"scene.toml:2:1: title1: unknown key, did you mean 'title'?"}},
    {"a wrong direction gives one message",
     camera + "[[directional_light]]\n"
              "direction = [\"a\", 0, 0]\n"
              "intensity = 1\n",
     {"scene.toml:3:14: directional_light[0].direction[0]: must be a number, got a string"}},
    {"a text of three quotes ends in up to five",
     camera + "image = {a = '''b'''', \xc3\xa4 = 1}\n",
     {"scene.toml:2:24: a character that may stand in quotes or behind a # only"}},
    {"columns count characters in what TOML does not read too",
     camera + "title = \"\xc3\xa4\" \xc3\xb6\n",
     {"scene.toml:2:13: a character that may stand in quotes or behind a # only"}},
    {"keys of many parts",
     camera + "a.a.a.a.a.a.a.a.a.a = 1\n",
     {"scene.toml:2:18: more dots than any key of a scene has; a text needs quotes"}},
    {"lists too deep",
     camera + "background = " + std::string(300, '[') + "\n",
     {"scene.toml:2:270: not valid TOML (value): exceeded maximum nested value depth of 256 (TOML_MAX_NESTED_VALUES)"}},
    {"not UTF-8", camera + "title = \"\xe4\"\n", {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"half a UTF-8 character",
     camera + "title = \"\xc3",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"UTF-16",
     std::string("\xff\xfem\x00"
                 "a\x00x\x00_\x00"
                 "b\x00o\x00u\x00n\x00"
                 "c\x00"
                 "e\x00s\x00 \x00=\x00 \x00"
                 "1\x00",
                 32),
     {"scene.toml:1:1: UTF-16 text; save the file as UTF-8"}},
    {"half of a UTF-16 pair",
     camera + "title = \"\xed\xa0\x80\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"a character beyond Unicode",
     camera + "title = \"\xf4\x90\x80\x80\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"an overlong character",
     camera + "title = \"\xe0\x9f\xbf\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"an overlong slash",
     camera + "title = \"\xc0\xaf\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"a wrong escape",
     camera + "title = \"\\q\"\n",
     {"scene.toml:2:11: not valid TOML (string): unknown escape sequence '\\q'"}},
    {"an overlong character of four",
     camera + "title = \"\xf0\x8f\xbf\xbf\"\n",
     {"scene.toml:2:10: not UTF-8 text from here on; save the file as UTF-8"}},
    {"a cloud needs its file",
     camera + "[[sphere_cloud]]\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:2:1: sphere_cloud[0].file: missing, must be a string"}},
    {"a cloud's file is a string",
     camera + "[[sphere_cloud]]\n"
              "file = 3\n"
              "color = [1, 1, 1]\n",
     {"scene.toml:3:8: sphere_cloud[0].file: must be a string, got 3"}},
    {"a cloud is opaque",
     camera + "[[sphere_cloud]]\n"
              "file = 3\n"
              "color = [1, 1, 1]\n"
              "transparent = true\n",
     {"scene.toml:3:8: sphere_cloud[0].file: must be a string, got 3",
      "scene.toml:5:1: sphere_cloud[0].transparent: unknown key; known keys: file, color, shininess"}},
    {"a cloud's shininess is a number",
     camera + "[[sphere_cloud]]\n"
              "file = 3\n"
              "shininess = \"much\"\n",
     {"scene.toml:3:8: sphere_cloud[0].file: must be a string, got 3",
      "scene.toml:4:13: sphere_cloud[0].shininess: must be a number, got a string"}},
    {"a cloud's file name is one line",
     camera + "[[sphere_cloud]]\n"
              "file = \"a\\u0000b\"\n",
     {"scene.toml:3:8: sphere_cloud[0].file: must be one line without control characters, got 'a\\x00b'"}},
};

}  // namespace

TEST_CASE("scene: every mistake is reported with its place, key, what is wanted and what was found", "[scene]") {
  for (const BadScene& bad : bad_scenes) {
    INFO(bad.what);
    const SceneFile file = parse_scene(bad.toml, "scene.toml");
    CHECK(messages(file) == bad.messages);
    CHECK_FALSE(file.scene.has_value());
  }
}

TEST_CASE("scene: a diagnostic holds its parts one by one", "[scene]") {
  const SceneFile file = parse_scene(camera + "[image]\nwidth = 0\n", "folder/my.toml");
  REQUIRE(file.diagnostics.size() == 1);
  const Diagnostic& diagnostic = file.diagnostics.front();
  CHECK(diagnostic.severity == Diagnostic::Severity::error);
  CHECK(diagnostic.file == "folder/my.toml");
  CHECK(diagnostic.line == 3);
  CHECK(diagnostic.column == 9);
  CHECK(diagnostic.key == "image.width");
  CHECK(diagnostic.text == "must be between 1 and 65536, got 0");
}

TEST_CASE("scene: the example of the specification is read as written", "[scene]") {
  const Scene scene = good(R"(title = "one line"
max_bounces = 7
background = [0.1, 0.2, 0.3]
[camera]
position = [0, 1, 5]
facing = [0, 0.5, -2]
up = [0.25, 3, 0]
half_field_of_view = 30.5
[image]
width = 1
height = 65536
[[plane]]
point = [0, -1, 0.5]
normal = [0, 2, 0.125]
color = [0.5, 0.25, 1.5]
shininess = 3
[[sphere]]
center = [0, 1, -7]
radius = 1.5
color = [0.9, 0.2, 0.4]
shininess = inf
transparent = true
refractive_index = 1.25
[[sphere]]
center = [9, 8, 7]
radius = 0.5
color = [0, 0.1, 0]
[[point_light]]
position = [2, 5, 3]
intensity = 40
[[directional_light]]
direction = [0, -1, -0.5]
intensity = 0.6
[[ambient_light]]
intensity = 0.1
[[ambient_light]]
intensity = 0
)");
  CHECK(scene.title == "one line");
  CHECK(scene.max_bounces == 7);
  CHECK(scene.background == Color(0.1, 0.2, 0.3));
  CHECK(scene.camera.position == Vec3(0, 1, 5));
  CHECK(scene.camera.facing == Vec3(0, 0.5, -2));
  CHECK(scene.camera.up == Vec3(0.25, 3, 0));
  CHECK(scene.camera.half_field_of_view == 30.5);
  CHECK(scene.image.width == 1);
  CHECK(scene.image.height == 65536);
  REQUIRE(scene.planes.size() == 1);
  CHECK(scene.planes[0].shape.point == Vec3(0, -1, 0.5));
  CHECK(scene.planes[0].shape.normal == Vec3(0, 2, 0.125));
  CHECK(scene.planes[0].material.color == Color(0.5, 0.25, 1.5));
  CHECK(scene.planes[0].material.shininess == 3);
  REQUIRE(scene.spheres.size() == 2);
  CHECK(scene.spheres[0].shape.center == Vec3(0, 1, -7));
  CHECK(scene.spheres[0].shape.radius == 1.5);
  CHECK(scene.spheres[0].material.color == Color(0.9, 0.2, 0.4));
  CHECK(scene.spheres[0].material.shininess == std::numeric_limits<double>::infinity());
  CHECK(scene.spheres[0].material.transparent);
  CHECK(scene.spheres[0].material.refractive_index == 1.25);
  CHECK(scene.spheres[1].shape.center == Vec3(9, 8, 7));
  REQUIRE(scene.point_lights.size() == 1);
  CHECK(scene.point_lights[0].position == Vec3(2, 5, 3));
  CHECK(scene.point_lights[0].intensity == 40);
  REQUIRE(scene.directional_lights.size() == 1);
  CHECK(scene.directional_lights[0].direction == Vec3(0, -1, -0.5));
  CHECK(scene.directional_lights[0].intensity == 0.6);
  REQUIRE(scene.ambient_lights.size() == 2);
  CHECK(scene.ambient_lights[0].intensity == 0.1);
  CHECK(scene.ambient_lights[1].intensity == 0);
}

TEST_CASE("scene: what is optional has its default", "[scene]") {
  const Scene scene =
      good(camera + sphere("[0, 0, -5]", "1") + "[[plane]]\npoint = [0, -2, 0]\nnormal = [0, 1, 0]\ncolor = [0, 0, 0]\n");
  CHECK(scene.title.empty());
  CHECK(scene.max_bounces == 5);
  CHECK(scene.background == Color(0, 0, 0));
  CHECK(scene.camera.half_field_of_view == 45);
  CHECK(scene.image.width == 640);
  CHECK(scene.image.height == 480);
  CHECK(scene.planes.at(0).material.shininess == 0);
  CHECK(scene.spheres.at(0).material.shininess == 0);
  CHECK_FALSE(scene.spheres.at(0).material.transparent);
  CHECK(scene.spheres.at(0).material.refractive_index == 1.5);
}

TEST_CASE("scene: no light and no geometry is legal", "[scene]") {
  CHECK(geometry_count(good(camera)) == 0);
  CHECK(good(camera + "sphere = []\npoint_light = []\n").point_lights.empty());
}

TEST_CASE("scene: a number is the double nearest its text", "[scene]") {
  const auto intensity = [](const std::string& text) {
    return good(camera + "[[ambient_light]]\nintensity = " + text + "\n").ambient_lights.at(0).intensity;
  };
  CHECK(intensity("0.1") == 0.1);
  CHECK(intensity("0.1000000000000000055511151231257827021181583404541015625") == 0.1);
  CHECK(intensity("0." + std::string(100, '3')) == 1.0 / 3);
  CHECK(intensity("9007199254740993") == 9007199254740992.0);  // 2^53 + 1: a tie, to even
  CHECK(intensity("9007199254740993.0") == 9007199254740992.0);
  CHECK(intensity("9007199254740995") == 9007199254740996.0);
  CHECK(intensity("9223372036854775807") == 9223372036854775808.0);
  CHECK(intensity("1.7976931348623157e308") == std::numeric_limits<double>::max());
  CHECK(intensity("5e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(intensity("3e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(intensity("2e-324") == 0);
  CHECK(intensity("1e-400") == 0);
  CHECK(intensity("1_000.5") == 1000.5);
  CHECK(intensity("+2") == 2);
  CHECK(intensity("-0.0") == 0);
  CHECK(intensity("0x10") == 16);
}

TEST_CASE("scene: ranges include their ends", "[scene]") {
  CHECK(good(camera + "max_bounces = 0\n").max_bounces == 0);
  CHECK(good(camera + "max_bounces = 100\n").max_bounces == 100);
  CHECK(good(camera + sphere("[0, 0, -5]", "1", "refractive_index = 0.1\n")).spheres.at(0).material.refractive_index == 0.1);
  CHECK(good(camera + sphere("[0, 0, -5]", "1", "refractive_index = 10\n")).spheres.at(0).material.refractive_index == 10);
  CHECK(good(camera + sphere("[1e100, -1e100, 5]", "1e-100")).spheres.at(0).shape.center == Vec3(1e100, -1e100, 5));
  CHECK(good(camera + sphere("[0, 0, -1e100]", "1e100")).spheres.at(0).shape.radius == 1e100);
}

TEST_CASE("scene: directions may have any length but zero", "[scene]") {
  const auto with = [](const std::string& facing, const std::string& up) {
    return good("[camera]\nposition = [0, 0, 0]\nfacing = " + facing + "\nup = " + up + "\n").camera;
  };
  CHECK(with("[0, 0, -5e-324]", "[0, 1.7e308, 0]").facing == Vec3(0, 0, -5e-324));
  CHECK(with("[5e-324, 5e-324, 0]", "[0, 5e-324, 0]").up == Vec3(0, 5e-324, 0));
  CHECK(with("[1e308, 1e308, 1e308]", "[1e308, 1e308, -1e308]").up == Vec3(1e308, 1e308, -1e308));
  CHECK(with("[0, 0, -1]", "[0, 2e-12, 1]").up == Vec3(0, 2e-12, 1));
}

TEST_CASE("scene: the forms that TOML has for a table are one", "[scene]") {
  const std::string line = camera + "image = {width = 3}\nsphere = [{center = [0, 0, -5], radius = 1, color = [1, 1, 1]}]\n";
  const std::string dotted =
      "camera.position = [0, 0, 0]\ncamera.facing = [0, 0, -1]\ncamera.up = [0, 1, 0]\nimage.width = 3\n" +
      sphere("[0, 0, -5]", "1");
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  std::string crlf;
  for (const char c : dotted) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& toml : {line, dotted, byte_order_mark + dotted, crlf}) {
    const Scene scene = good(toml);
    CHECK(scene.camera.up == Vec3(0, 1, 0));
    CHECK(scene.image.width == 3);
    CHECK(scene.spheres.at(0).shape.center == Vec3(0, 0, -5));
  }
}

TEST_CASE("scene: dots in texts and comments are no keys of many parts", "[scene]") {
  CHECK(good("title = 'wait ... ... ... ...' # . . . . . . . . . . . .\n" + camera).title == "wait ... ... ... ...");
  CHECK(good("title='\xC3\xA4'\n" + camera).title == "\xC3\xA4");
  CHECK(good("title = '\\\xC3\xA4'\n" + camera).title == "\\\xC3\xA4");
  CHECK(good("title = \"a \\\" ............\"\n" + camera).title == "a \" ............");
  CHECK(good("title = \"\"\".'.........\\\n  .......\"\"\"\n" + camera).title == ".'................");
  CHECK(good("title = '''\"'.........'''''\n" + camera).title == "\"'.........''");
}

TEST_CASE("scene: the camera inside a sphere is a warning", "[scene]") {
  CHECK(warnings(camera + sphere("[0, 0, 1]", "1.5")) ==
        Messages{"scene.toml:1:22: warning: camera.position: inside sphere[0]"});
  CHECK(warnings(camera + sphere("[0, 0, 1]", "1")) == Messages{});
  CHECK(warnings(camera + sphere("[9, 0, 0]", "1") + sphere("[0, 0, 1]", "1.5") + sphere("[0, 0, 2]", "3")) ==
        Messages{"scene.toml:1:22: warning: camera.position: inside sphere[1] and 1 more"});
}

TEST_CASE("scene: glass that holds or cuts another geometry is a warning", "[scene]") {
  const std::string glass = camera + sphere("[0, 0, -9]", "2", "transparent = true\n");
  const std::string plane = "[[plane]]\nnormal = [0, 3, 0]\ncolor = [1, 1, 1]\npoint = ";
  const std::string begin = "scene.toml:2:1: warning: sphere[0]: transparent, but it holds or cuts ";

  CHECK(warnings(glass + sphere("[0.5, 0, -9]", "1")) == Messages{begin + "sphere[1]"});
  CHECK(warnings(glass + sphere("[0, 2.9, -9]", "1")) == Messages{begin + "sphere[1]"});
  CHECK(warnings(glass + plane + "[7, 1.9, 7]\n") == Messages{begin + "plane[0]"});
  CHECK(warnings(glass + sphere("[0, 0, -9]", "1") + plane + "[0, 0, 0]\n" + sphere("[0, 0, -10]", "0.5")) ==
        Messages{begin + "plane[0] and 2 more"});

  CHECK(warnings(glass + sphere("[0, 3, -9]", "1")) == Messages{});  // touches from outside
  CHECK(warnings(glass + plane + "[7, -2, 7]\n") == Messages{});     // lies on it
  CHECK(warnings(glass + sphere("[0, 0, -9]", "3")) == Messages{});  // an opaque shell around it
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2") + sphere("[0, 0, -9]", "1")) == Messages{});
}

TEST_CASE("scene: what touches in decimals is not cut in doubles", "[scene]") {
  // 0.1 + 0.2 is more than 0.3 in doubles.
  CHECK(warnings(camera + sphere("[0.3, 0, -9]", "0.1", "transparent = true\n") + sphere("[0, 0, -9]", "0.2")) ==
        Messages{});
}

TEST_CASE("scene: glass that cuts glass is one warning, glass in glass is the outer one's", "[scene]") {
  const std::string glass = "transparent = true\n";
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2", glass) + sphere("[3, 0, -9]", "2", glass)) ==
        Messages{"scene.toml:2:1: warning: sphere[0]: transparent, but it holds or cuts sphere[1]"});
  CHECK(warnings(camera + sphere("[0, 0, -9]", "1", glass) + sphere("[0, 0, -9]", "2", glass)) ==
        Messages{"scene.toml:7:1: warning: sphere[1]: transparent, but it holds or cuts sphere[0]"});
}

TEST_CASE("scene: identical geometry is a warning", "[scene]") {
  const std::string plane = "[[plane]]\npoint = [0, -2, 0]\nnormal = [0, 1, 0]\ncolor = [1, 1, 1]\n";
  CHECK(warnings(camera + plane + plane + plane) == Messages{"scene.toml:6:1: warning: plane[1]: identical to plane[0]",
                                                             "scene.toml:10:1: warning: plane[2]: identical to plane[0]"});
  CHECK(warnings(camera + plane + plane + "shininess = 1\n") == Messages{});
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2") + sphere("[0, -0.0, -9]", "2", "refractive_index = 2\n")) ==
        Messages{"scene.toml:6:1: warning: sphere[1]: identical to sphere[0]"});
  CHECK(warnings(camera + sphere("[0, 0, -9]", "2") + sphere("[0, 0, -9]", "2", "shininess = 1\n")) == Messages{});
}

TEST_CASE("scene: glass of another index is not identical", "[scene]") {
  const auto two_of_glass = [](const std::string& index) {
    const std::string more = "transparent = true\nrefractive_index = ";
    return warnings(camera + sphere("[0, 0, -9]", "2", more + "1.5\n") + sphere("[0, 0, -9]", "2", more + index + "\n"));
  };
  const Messages both_hold{"scene.toml:2:1: warning: sphere[0]: transparent, but it holds or cuts sphere[1]",
                           "scene.toml:8:1: warning: sphere[1]: transparent, but it holds or cuts sphere[0]"};
  CHECK(two_of_glass("1.6") == both_hold);
  CHECK(two_of_glass("1.50") ==
        Messages{both_hold[0], both_hold[1], "scene.toml:8:1: warning: sphere[1]: identical to sphere[0]"});
}

TEST_CASE("scene: a scene with a mistake gets no warnings about what it would be", "[scene]") {
  const SceneFile file = parse_scene(camera + sphere("[0, 0, 0]", "1") + "[image]\nwidth = 0\n", "scene.toml");
  CHECK(messages(file) == Messages{"scene.toml:7:9: image.width: must be between 1 and 65536, got 0"});
}

TEST_CASE("scene: a file is read as its text is", "[scene]") {
  const TemporaryFolder folder;
  const SceneFile file = read_scene(folder.write("good.toml", camera + "title = \"from disk\"\n"));
  CHECK(messages(file) == Messages{});
  REQUIRE(file.scene.has_value());
  CHECK(file.scene->title == "from disk");
}

TEST_CASE("scene: a file that cannot be read says why", "[scene]") {
  const TemporaryFolder folder;
  const auto only_message = [](const fs::path& path) {
    const SceneFile file = read_scene(path);
    CHECK_FALSE(file.scene.has_value());
    REQUIRE(file.diagnostics.size() == 1);
    return to_string(file.diagnostics.front());
  };
  fs::create_directory(folder / "folder.toml");
  fs::create_symlink("nowhere.toml", folder / "dangling.toml");
  fs::create_symlink("loop.toml", folder / "loop.toml");
  folder.write("huge.toml", "");
  fs::resize_file(folder / "huge.toml", (16U << 20U) + 1);
  folder.write("empty.toml", "");

  const auto named = [&](const std::string& name) { return (folder / name).string(); };
  CHECK(only_message(named("none.toml")) == named("none.toml") + ": no such file");
  CHECK(only_message(named("folder.toml")) == named("folder.toml") + ": a directory; name a file in it");
  CHECK(only_message(named("dangling.toml")) == named("dangling.toml") + ": no such file");
  CHECK(only_message(named("loop.toml")) == named("loop.toml") + ": Too many levels of symbolic links");
  CHECK(only_message(named("empty.toml")) == named("empty.toml") + ": an empty file");
  CHECK(only_message(named("huge.toml")) ==
        named("huge.toml") + ": too large, 16777217 bytes, where at most 16777216 are read");
}
