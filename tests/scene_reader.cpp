// What a good scene file becomes.
#include "tests/scene_text.hpp"
#include "tests/temporary_folder.hpp"

#include <filesystem>
#include <limits>

using namespace raylab;
using namespace raylab::test;

namespace fs = std::filesystem;

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
