#include "core/scene/read_cloud.hpp"
#include "core/scene/read_decimal.hpp"
#include "core/scene/read_scene.hpp"
#include "tests/catch.hpp"
#include "tests/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using namespace raylab;
using raylab::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

using Messages = std::vector<std::string>;

Messages texts(const std::vector<Diagnostic>& diagnostics) {
  Messages result;
  for (const Diagnostic& diagnostic : diagnostics) result.push_back(to_string(diagnostic));
  return result;
}

Messages mistakes(const std::string& table) {
  Report report("cloud.csv");
  parse_cloud(table, "sphere_cloud[0]", report);
  return texts(report.sorted());
}

CloudTable good(const std::string& table) {
  Report report("cloud.csv");
  CloudTable cloud = parse_cloud(table, "sphere_cloud[0]", report);
  CHECK(texts(report.sorted()) == Messages{});
  return cloud;
}

/// Reads a scene in `folder` with a far camera and this [[sphere_cloud]], whose header is in line 2.
SceneFile scene_in(const TemporaryFolder& folder, const std::string& cloud) {
  return read_scene(folder.write(
      "scene.toml", "camera = {position = [0, 0, 1e9], facing = [0, 0, -1], up = [0, 1, 0]}\n[[sphere_cloud]]\n" + cloud));
}

}  // namespace

TEST_CASE("scene: a cloud's rows become spheres", "[scene]") {
  const CloudTable cloud = good("x,y,z,radius\n1,2,3,4\n-0.5,1e-3,.25,1e100\n");
  CHECK(cloud.has_colors == false);
  REQUIRE(cloud.spheres.size() == 2);
  CHECK(cloud.spheres[0].center == Vec3(1, 2, 3));
  CHECK(cloud.spheres[0].radius == 4);
  CHECK(cloud.spheres[1].center == Vec3(-0.5, 1e-3, 0.25));
  CHECK(cloud.spheres[1].radius == 1e100);
  CHECK(cloud.colors.empty());
}

TEST_CASE("scene: a cloud's rows may have colors", "[scene]") {
  const CloudTable cloud = good("x,y,z,radius,r,g,b\n1,2,3,4,0.1,0.2,0.3\n5,6,7,8,0,1,2.5\n");
  CHECK(cloud.has_colors == true);
  REQUIRE(cloud.colors.size() == 2);
  CHECK(cloud.colors[0] == Color(0.1, 0.2, 0.3));
  CHECK(cloud.colors[1] == Color(0, 1, 2.5));
  CHECK(cloud.spheres.size() == 2);
}

TEST_CASE("scene: a cloud's lines end in LF or CRLF, the last one in either or nothing", "[scene]") {
  const std::vector<std::string> tables{
      "x,y,z,radius\n1,2,3,4\n5,6,7,8",       "x,y,z,radius\n1,2,3,4\n5,6,7,8\n",
      "x,y,z,radius\r\n1,2,3,4\r\n5,6,7,8",   "x,y,z,radius\r\n1,2,3,4\r\n5,6,7,8\r\n",
      "x,y,z,radius\n1,2,3,4\r\n5,6,7,8\n\n", "x,y,z,radius\r\n1,2,3,4\n5,6,7,8\r\n\r\n\n"};
  for (const std::string& table : tables) {
    const CloudTable cloud = good(table);
    REQUIRE(cloud.spheres.size() == 2);
    CHECK(cloud.spheres[1].center == Vec3(5, 6, 7));
    CHECK(cloud.spheres[1].radius == 8);
  }
}

TEST_CASE("scene: every wrong field of a cloud is reported with its line and column", "[scene]") {
  struct BadTable {
    std::string table;
    Messages messages;
  };
  const std::string wanted = "cloud.csv:1:1: sphere_cloud[0]: the header must be x,y,z,radius or x,y,z,radius,r,g,b, got ";
  const std::string key = "sphere_cloud[0]";
  const std::vector<BadTable> tables{
      {"", {wanted + "''"}},
      {"\n", {wanted + "''"}},
      {"1,2,3,4\n", {wanted + "'1,2,3,4'"}},
      {"x, y, z, radius\n1,2,3,4\n", {wanted + "'x, y, z, radius'"}},
      {"X,Y,Z,RADIUS\n1,2,3,4\n", {wanted + "'X,Y,Z,RADIUS'"}},
      {"x,y,z,radius,r,g\n1,2,3,4,5,6\n", {wanted + "'x,y,z,radius,r,g'"}},
      {"x,y,z,radius \n1,2,3,4\n", {wanted + "'x,y,z,radius '"}},
      {"x,y,z,radius\r1,2,3,4\r", {wanted + "'x,y,z,radius\\x0d1,2,3,4'"}},
      {"\xFFx\n", {wanted + "'\\xffx'"}},
      {"\xEF\xBB\xBFx,y,z,radius\n1,2,3,4\n",
       {"cloud.csv:1:1: " + key + ": begins with a byte order mark; save the file as UTF-8 without one"}},
      {"x,y,z,radius", {"cloud.csv:2:1: " + key + ": no rows: at least one sphere must follow the header"}},
      {"x,y,z,radius\n\n\n", {"cloud.csv:2:1: " + key + ": no rows: at least one sphere must follow the header"}},
      {"x,y,z,radius\n1,2,3,4\n\n5,6,7,8\n", {"cloud.csv:3:1: " + key + ": an empty line between rows; remove it"}},
      {"x,y,z,radius\n1,2,3\n", {"cloud.csv:2:1: " + key + ": must be 4 numbers, got 3"}},
      {"x,y,z,radius\n1,2,3,4,5\n", {"cloud.csv:2:1: " + key + ": must be 4 numbers, got 5"}},
      {"x,y,z,radius\n1,2,3,4,\n", {"cloud.csv:2:1: " + key + ": must be 4 numbers, got 5"}},
      {"x,y,z,radius,r,g,b\n1,2,3,4\n", {"cloud.csv:2:1: " + key + ": must be 7 numbers, got 4"}},
      {"x,y,z,radius\n1;2;3;4\n",
       {"cloud.csv:2:1: " + key + ".x: must be a number, got '1;2;3;4'",
        "cloud.csv:2:1: " + key + ": must be 4 numbers, got 1"}},
      {"x,y,z,radius\n1,2,3,-4\n", {"cloud.csv:2:7: " + key + ".radius: must be greater than 0, got -4"}},
      {"x,y,z,radius\n1,2,3,0\n", {"cloud.csv:2:7: " + key + ".radius: must be greater than 0, got 0"}},
      {"x,y,z,radius\n1,2,3,1e-101\n", {"cloud.csv:2:7: " + key + ".radius: must be between 1e-100 and 1e100, got 1e-101"}},
      {"x,y,z,radius\n1,2,3,1e-400\n", {"cloud.csv:2:7: " + key + ".radius: must be greater than 0, got 1e-400"}},
      {"x,y,z,radius\n1,2,3,1e400\n", {"cloud.csv:2:7: " + key + ".radius: must be a finite number, got 1e400"}},
      {"x,y,z,radius\n1,2e100,3,1\n", {"cloud.csv:2:3: " + key + ".y: must be between -1e100 and 1e100, got 2e100"}},
      {"x,y,z,radius\nnan,-inf,3,1\n",
       {"cloud.csv:2:1: " + key + ".x: must be a finite number, got nan",
        "cloud.csv:2:5: " + key + ".y: must be a finite number, got -inf"}},
      {"x,y,z,radius\n,2, 3,4\n",
       {"cloud.csv:2:1: " + key + ".x: must be a number, got ''",
        "cloud.csv:2:4: " + key + ".z: must be a number, got ' 3'"}},
      {"x,y,z,radius\n1x,0x1,+3,4m\n",
       {"cloud.csv:2:1: " + key + ".x: must be a number, got '1x'",
        "cloud.csv:2:4: " + key + ".y: must be a number, got '0x1'",
        "cloud.csv:2:8: " + key + ".z: must be a number, got '+3'",
        "cloud.csv:2:11: " + key + ".radius: must be a number, got '4m'"}},
      {"x,y,z,radius,r,g,b\n1,2,3,4,-1,nan,1e999\n",
       {"cloud.csv:2:9: " + key + ".r: must be at least 0, got -1",
        "cloud.csv:2:12: " + key + ".g: must be a finite number, got nan",
        "cloud.csv:2:16: " + key + ".b: must be a finite number, got 1e999"}},
      {"x,y,z,radius\n1,2,3,-4\n1,2,3,4\n1,2,3,a\n",
       {"cloud.csv:2:7: " + key + ".radius: must be greater than 0, got -4",
        "cloud.csv:4:7: " + key + ".radius: must be a number, got 'a'"}},
  };
  for (const BadTable& bad : tables) {
    INFO(bad.table);
    CHECK(mistakes(bad.table) == bad.messages);
  }
}

TEST_CASE("scene: a cloud that is wrong throughout does not fill the memory with reports", "[scene]") {
  std::string table = "x,y,z,radius\n";
  for (int i = 0; i < 100'001; ++i) table += "1,2,3,-4\n";
  const Messages found = mistakes(table);
  REQUIRE(found.size() == 100'001);
  CHECK(found[99'999] == "cloud.csv:100001:7: sphere_cloud[0].radius: must be greater than 0, got -4");
  CHECK(found.back() == "cloud.csv:100002:1: sphere_cloud[0]: not read from here on: 100000 mistakes before");
}

TEST_CASE("scene: a cloud's number is the double nearest its text", "[scene]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(parse_decimal("0.1") == 0.1);
  CHECK(parse_decimal("0.1000000000000000055511151231257827021181583404541015625") == 0.1);
  CHECK(parse_decimal("9007199254740993") == 9007199254740992.0);
  CHECK(parse_decimal("2.2250738585072011e-308") == 2.2250738585072011e-308);
  CHECK(parse_decimal("3e-324") == least);
  CHECK(parse_decimal("2.4703282292062328e-324") == least);
  CHECK(parse_decimal("2.4703282292062327e-324") == 0);
  CHECK(parse_decimal("1e-400") == 0);
  CHECK(std::signbit(*parse_decimal("-1e-400")));
  CHECK(parse_decimal("1e99999999999") == infinity);
  CHECK(parse_decimal("1E+400") == infinity);
  CHECK(parse_decimal("-1e400") == -infinity);
  CHECK(parse_decimal("1e-99999999999") == 0);
  CHECK(parse_decimal("0e99999999999") == 0);
  CHECK(parse_decimal("0." + std::string(400, '0') + "1") == 0);
  CHECK(parse_decimal("1" + std::string(400, '0')) == infinity);
  CHECK(parse_decimal("1" + std::string(400, '0') + "e-400") == 1);
  CHECK(parse_decimal("1" + std::string(400, '0') + "e-800") == 0);
  CHECK(parse_decimal("0." + std::string(400, '0') + "1e800") == infinity);
  for (const char* text : {"", "-", "+1", " 1", "1 ", "0x10", "1e", "1_0", "one", "--1", "1,5"}) {
    INFO(text);
    CHECK_FALSE(parse_decimal(text).has_value());
  }
}

TEST_CASE("scene: a cloud is read from its file beside the scene", "[scene]") {
  const TemporaryFolder folder;
  folder.write("cloud.csv", "x,y,z,radius\n1,2,3,4\n");
  fs::create_directory((folder / "sub").string());
  fs::rename((folder / "cloud.csv").string(), (folder / "sub/cloud.csv").string());
  for (const std::string& name :
       {std::string("sub/cloud.csv"), std::string("./sub/../sub/cloud.csv"), (folder / "sub/cloud.csv").string()}) {
    const SceneFile file = scene_in(folder, "file = \"" + name + "\"\ncolor = [0.1, 0.2, 0.3]\nshininess = 7\n");
    CHECK(texts(file.diagnostics) == Messages{});
    REQUIRE(file.scene.has_value());
    REQUIRE(file.scene->clouds.size() == 1);
    CHECK(file.scene->clouds[0].spheres.size() == 1);
    CHECK(file.scene->clouds[0].spheres[0].center == Vec3(1, 2, 3));
    CHECK(file.scene->clouds[0].colors.empty());
    CHECK(file.scene->clouds[0].material.color == Color(0.1, 0.2, 0.3));
    CHECK(file.scene->clouds[0].material.shininess == 7);
    CHECK_FALSE(file.scene->clouds[0].material.transparent);
  }
}

TEST_CASE("scene: a cloud has its color from the section or from the table", "[scene]") {
  const TemporaryFolder folder;
  folder.write("plain.csv", "x,y,z,radius\n1,2,3,4\n");
  folder.write("colors.csv", "x,y,z,radius,r,g,b\n1,2,3,4,0.5,0.25,0\n");
  const std::string scene = (folder / "scene.toml").string();

  CHECK(texts(scene_in(folder, "file = \"plain.csv\"\n").diagnostics) ==
        Messages{scene + ":2:1: sphere_cloud[0].color: missing, must be a list of 3 numbers"});

  const SceneFile colored = scene_in(folder, "file = \"colors.csv\"\n");
  CHECK(texts(colored.diagnostics) == Messages{});
  CHECK(colored.scene.value().clouds.at(0).colors.at(0) == Color(0.5, 0.25, 0));

  const SceneFile both = scene_in(folder, "file = \"colors.csv\"\ncolor = [1, 1, 1]\n");
  CHECK(texts(both.diagnostics) ==
        Messages{scene + ":4:9: warning: sphere_cloud[0].color: not used: colors.csv has a color for each sphere"});
  CHECK(both.scene.value().clouds.at(0).colors.at(0) == Color(0.5, 0.25, 0));
}

TEST_CASE("scene: a cloud's file that cannot be read is a mistake at its name", "[scene]") {
  const TemporaryFolder folder;
  fs::create_directory((folder / "folder").string());
  folder.write("empty", "");
  const auto check = [&](const std::string& name, const std::string& why) {
    const SceneFile file = scene_in(folder, "file = \"" + name + "\"\n");
    CHECK_FALSE(file.scene.has_value());
    CHECK(texts(file.diagnostics) == Messages{(folder / "scene.toml").string() + ":3:8: sphere_cloud[0].file: cannot read " +
                                              (folder / name).string() + ": " + why});
  };
  check("none.csv", "no such file");
  check("folder", "a directory; name a file in it");
  check("", "a directory; name a file in it");
  check("empty", "an empty file");
  check(std::string(300, 'n'), "File name too long");
}

TEST_CASE("scene: the mistakes of all tables come in one run, after the scene's own", "[scene]") {
  const TemporaryFolder folder;
  folder.write("a.csv", "x,y,z,radius\n1,2,3,0\n");
  folder.write("b.csv", "x,y,z,radius\n1,2,3,4\n1,2,c,4\n");
  const SceneFile file = scene_in(folder, "file = \"a.csv\"\ncolor = [1, 1, -1]\n[[sphere_cloud]]\nfile = \"b.csv\"\n");
  CHECK_FALSE(file.scene.has_value());
  CHECK(texts(file.diagnostics) ==
        Messages{(folder / "scene.toml").string() + ":4:16: sphere_cloud[0].color[2]: must be at least 0, got -1",
                 (folder / "scene.toml").string() + ":5:1: sphere_cloud[1].color: missing, must be a list of 3 numbers",
                 (folder / "a.csv").string() + ":2:7: sphere_cloud[0].radius: must be greater than 0, got 0",
                 (folder / "b.csv").string() + ":3:5: sphere_cloud[1].z: must be a number, got 'c'"});
}

TEST_CASE("scene: a mistake in a table alone is enough to have no scene", "[scene]") {
  const TemporaryFolder folder;
  folder.write("a.csv", "x,y,z,radius\n1,2,3,0\n");
  CHECK_FALSE(scene_in(folder, "file = \"a.csv\"\ncolor = [1, 1, 1]\n").scene.has_value());
}

TEST_CASE("scene: a cloud gets one warning of each kind", "[scene]") {
  const TemporaryFolder folder;
  folder.write("a.csv", "x,y,z,radius\n0,0,0,1\n5,0,0,1\n0,0,0,1\n5,0,0,1\n0,0,1e9,2\n0,0,1e9,3\n");
  const std::string scene = (folder / "scene.toml").string();
  const SceneFile file =
      scene_in(folder,
               "file = \"a.csv\"\ncolor = [1, 1, 1]\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\ncolor = [1, 1, 1]\n"
               "[[sphere]]\ncenter = [5, 0, 0]\nradius = 2\ncolor = [1, 1, 1]\ntransparent = true\n");
  CHECK(file.scene.has_value());
  CHECK(texts(file.diagnostics) ==
        Messages{scene + ":1:22: warning: camera.position: inside sphere_cloud[0] line 6 and 1 more",
                 scene + ":2:1: warning: sphere_cloud[0]: line 2 is identical to sphere[0], and 2 more lines are twins",
                 scene + ":9:1: warning: sphere[1]: transparent, but it holds or cuts sphere_cloud[0] line 3 and 1 more"});
}

TEST_CASE("scene: spheres of a cloud that differ in color are not identical", "[scene]") {
  const TemporaryFolder folder;
  folder.write("a.csv", "x,y,z,radius,r,g,b\n0,0,0,1,1,0,0\n0,0,0,1,0,1,0\n");
  CHECK(texts(scene_in(folder, "file = \"a.csv\"\n").diagnostics) == Messages{});
  folder.write("a.csv", "x,y,z,radius,r,g,b\n0,0,0,1,1,0,0\n0,0,0,1,1,0,0\n");
  CHECK(texts(scene_in(folder, "file = \"a.csv\"\n").diagnostics) ==
        Messages{(folder / "scene.toml").string() +
                 ":2:1: warning: sphere_cloud[0]: line 3 is identical to sphere_cloud[0] line 2"});
}

TEST_CASE("scene: a cloud of a million spheres is read to its end", "[scene]") {
  constexpr int count = 1'000'000;
  std::string table = "x,y,z,radius,r,g,b\n";
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    table += n + "," + n + ".5,-" + n + ",1.25,0.5,0." + n + ",1\n";
  }
  const CloudTable cloud = good(table);
  REQUIRE(cloud.spheres.size() == count);
  REQUIRE(cloud.colors.size() == count);
  for (const int i : {0, 1, 499'999, 999'999}) {
    const auto index = static_cast<std::size_t>(i);
    CHECK(cloud.spheres[index].center == Vec3(i, i + 0.5, -i));
    CHECK(cloud.spheres[index].radius == 1.25);
    CHECK(cloud.colors[index] == Color(0.5, std::stod("0." + std::to_string(i)), 1));
  }
}
