// The parts of core/grade that run no strangers' code; tests/grade_test.sh has the rest.

#include "core/grade/grading.hpp"
#include "core/calls/plain_json.hpp"
#include "core/grade/class_folder.hpp"
#include "core/grade/view.hpp"
#include "core/image/data_folder.hpp"
#include "core/scene/read_scene.hpp"
#include "core/submission/taken_files.hpp"
#include "tests/catch.hpp"
#include "tests/temporary_folder.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

Grading usual() { return read_grading(data_folder("course/grading.toml"), {}).grading.value(); }

std::vector<std::string> complaints(const std::string& toml) {
  const TemporaryFolder folder;
  write(folder / "grading.toml", toml);
  std::vector<std::string> all;
  for (const Diagnostic& diagnostic : read_grading(folder / "grading.toml", usual()).diagnostics)
    all.push_back(std::to_string(diagnostic.line) + ": " + diagnostic.key);
  return all;
}

using Complaints = std::vector<std::string>;

}  // namespace

TEST_CASE("grading: an image's points fall with the logarithm of the share outside", "[grading]") {
  constexpr std::size_t pixels = 10000, allowed = 10;
  CHECK(image_credit(0, allowed, pixels, 0.1) == 1);
  CHECK(image_credit(10, allowed, pixels, 0.1) == 1);
  CHECK(image_credit(100, allowed, pixels, 0.1) == Approx(0.5));
  CHECK(image_credit(11, allowed, pixels, 0.1) < 1);
  CHECK(image_credit(1000, allowed, pixels, 0.1) == 0);
  CHECK(image_credit(pixels, allowed, pixels, 0.1) == 0);
}

TEST_CASE("grading: where not even one pixel may be outside, one is still worth most of the points", "[grading]") {
  CHECK(image_credit(0, 0, 500, 0.3) == 1);
  CHECK(image_credit(1, 0, 500, 0.3) == 1);
  CHECK(image_credit(2, 0, 500, 0.3) < 1);
  CHECK(image_credit(150, 0, 500, 0.3) == 0);
}

TEST_CASE("grading: the usual file has all stages, 100 points, and a bonus for the optional ones", "[grading]") {
  const Grading grading = usual();
  REQUIRE(grading.stages.size() == 7);
  double points = 0;
  for (const StageGrading& stage : grading.stages) {
    if (!stage.bonus) points += stage.points;
    CHECK_FALSE(stage.shown.empty());
    CHECK_FALSE(stage.scenes.empty());
  }
  CHECK(points == 100);
  CHECK_FALSE(grading.stages[3].bonus);
  CHECK(grading.stages[4].bonus);
}

TEST_CASE("grading: what a file leaves out stays as it is usually", "[grading]") {
  const TemporaryFolder folder;
  write(folder / "grading.toml",
        "[[stage]]\nstage = 2\npoints = 50\n[[hidden_test]]\ntask = \"5.1\"\ncall = '{\"d\": [0, -1, 0], \"n\": [0, 1, "
        "0]}'\n");
  const Grading grading = read_grading(folder / "grading.toml", usual()).grading.value();
  CHECK(grading.stages[1].points == 50);
  CHECK(grading.stages[1].images == usual().stages[1].images);
  CHECK(grading.stages[0].points == usual().stages[0].points);
  REQUIRE(grading.hidden.size() == 1);
  CHECK(grading.hidden[0].task == "5.1");
}

TEST_CASE("grading: mistakes in a file are told with their places, all at once", "[grading]") {
  CHECK(complaints("[limits]\ncall = 0\nmemory = 1\n") == Complaints{"2: limits.call", "3: limits.memory"});
  CHECK(complaints("[[stage]]\nstage = 8\npoints = -1\nimages = 2\nscenes = [1]\n") ==
        Complaints{"2: stage[0].stage", "3: stage[0].points", "4: stage[0].images", "5: stage[0].scenes"});
  CHECK(complaints("[hints]\nlevel = 4\n[weights]\n") == Complaints{"2: hints.level", "3: weights"});
  CHECK(complaints("[[hidden_test]]\ntask = \"9.9\"\ncall = '{}'\n") == Complaints{"2: hidden_test[0].task"});
}

TEST_CASE("grading: drawn cameras follow from the seed alone, and differ", "[grading]") {
  const Scene scene = read_scene(data_folder("scenes/scene3.toml")).scene.value();
  std::mt19937_64 one(7), same(7), other(8);
  const std::string first = to_json(drawn_camera(scene, one));
  CHECK(to_json(drawn_camera(scene, same)) == first);
  CHECK(to_json(drawn_camera(scene, one)) != first);
  CHECK(to_json(drawn_camera(scene, other)) != first);
  CHECK(first != to_json(scene.camera));
}

TEST_CASE("grading: of a submission its regular files are taken, and nothing through a link", "[grading]") {
  const TemporaryFolder folder;
  write(folder / "mia" / "01_rays.cpp", "int x;");
  write(folder / "mia" / "notes.txt", "mine");
  fs::create_symlink("/etc/passwd", folder / "mia" / "02_intersections.cpp");
  fs::create_directory(folder / "mia" / "03_blinn_phong.cpp");
  write(folder / "mia" / "04_shadows.cpp", std::string((1U << 20U) + 1, ' '));
  write(folder / "mia" / "05_reflections.cpp", "");
  const TakenFiles files = take_files(folder / "mia");
  CHECK(files.texts.size() == 2);
  CHECK(files.texts.at(1) == "int x;");
  CHECK(files.texts.at(5).empty());
  REQUIRE(files.refused.size() == 3);
  CHECK(files.refused.at(2) == "02_intersections.cpp is a link: hand in the file itself");
  CHECK(files.refused.at(3).find("is no file") != std::string::npos);
  CHECK(files.refused.at(4).find("is too large: 1048577 bytes") != std::string::npos);
}

TEST_CASE("grading: files that lie one folder deeper are found, if there is one such folder", "[grading]") {
  const TemporaryFolder folder;
  write(folder / "mia" / "lab" / "01_rays.cpp", "int x;");
  CHECK(take_files(folder / "mia").texts.at(1) == "int x;");
  write(folder / "mia" / "old" / "01_rays.cpp", "int y;");
  CHECK(take_files(folder / "mia").texts.empty());
}

TEST_CASE("grading: submissions are found by name, and parts of them make the whole", "[grading]") {
  const TemporaryFolder folder;
  for (const char* name : {"dee", "ada", "cy", "bob", "eve"}) write(folder / "class" / name / "01_rays.cpp", "int x;");
  const std::vector<Submitted> all = find_submissions({(folder / "class").string()}, "seed");
  REQUIRE(all.size() == 5);
  CHECK(all.front().name == "ada");
  CHECK(all.back().name == "eve");
  CHECK(all[0].id != all[1].id);
  CHECK(find_submissions({(folder / "class" / "ada").string()}, "seed").front().id == all[0].id);
  CHECK(find_submissions({(folder / "class" / "ada" / "").string()}, "seed").front().id == all[0].id);
  CHECK(find_submissions({(folder / "class").string()}, "other").front().id != all[0].id);
  CHECK(shard(all, 0, 2).size() == 3);
  CHECK(shard(all, 1, 2).front().name == "bob");
  CHECK(shard(all, 4, 5).front().name == "eve");
  fs::create_directory(folder / "empty");
  CHECK_THROWS_AS(find_submissions({(folder / "empty").string()}, "seed"), std::runtime_error);
  write(folder / "again" / "ada" / "01_rays.cpp", "int x;");
  CHECK_THROWS_AS(find_submissions({(folder / "class").string(), (folder / "again").string()}, "seed"), std::runtime_error);
}

TEST_CASE("grading: a finished result counts as long as its inputs stay the same", "[grading]") {
  const TemporaryFolder folder;
  const ClassFolder out(folder / "out", "seed");
  CHECK_FALSE(out.finished("a1", "inputs"));
  SubmissionResult result;
  result.id = "a1";
  result.inputs = "inputs";
  result.notes = {"a note"};
  out.finish(result, 1.5);
  REQUIRE(out.finished("a1", "inputs"));
  CHECK(out.finished("a1", "inputs")->notes == result.notes);
  CHECK_FALSE(out.finished("a1", "others"));
  CHECK(out.seconds().front().second == 1.5);
  write(folder / "out" / "submissions" / "a1" / "result.json", "{\"id\":");
  CHECK_FALSE(out.finished("a1", "inputs"));
  CHECK_THROWS_AS(ClassFolder(folder / "out", "other"), std::runtime_error);
  CHECK((fs::status(folder / "out").permissions() & (fs::perms::group_all | fs::perms::others_all)) == fs::perms::none);
}
