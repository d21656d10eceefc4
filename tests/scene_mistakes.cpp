// What the reader says of wrong values.
#include "tests/scene_text.hpp"

using namespace raylab;
using namespace raylab::test;

namespace {

const std::vector<BadScene> bad_values{
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
    {"a wrong direction gives one message",
     camera + "[[directional_light]]\n"
              "direction = [\"a\", 0, 0]\n"
              "intensity = 1\n",
     {"scene.toml:3:14: directional_light[0].direction[0]: must be a number, got a string"}},
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
  check_bad(bad_values);
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
