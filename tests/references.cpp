// The checked-in references: every stage of solution and engine against them, and what a manifest promises.

#include "core/image/data_folder.hpp"
#include "core/image/diff_patterns.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/image_file.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/references/other_stage.hpp"
#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "core/report/diff_report.hpp"
#include "core/scene/read_scene.hpp"
#ifdef RAYLAB_WITH_ENGINE
#include "reference/engine/engine.hpp"
#endif
#include "tests/mistakes/mistakes.hpp"
#include "tests/support.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <fstream>
#include <string>

using namespace raylab;
using namespace raylab::test;

namespace fs = std::filesystem;

namespace {

Manifest checked_in() { return read_manifest(data_folder(manifest_file)); }
fs::path renders() { return data_folder(manifest_file).parent_path(); }

void check_same(const std::string& who, const SceneEntry& scene, int stage, const Image& image, const Reference& reference) {
  const Comparison comparison = compare(image, NumberFormat::float64, reference);
  INFO(diff_text({who, scene.name + " at stage " + std::to_string(stage)}, comparison));
  CHECK(comparison.same);
}

/// Without the hard scenes: nobody's program is graded with those.
void check_stage(int stage, const char* who, const MakeEngine& make) {
  std::size_t scenes = 0;
  for (const SceneEntry& scene : checked_in().scenes) {
    if (is_hard(scene.sources.front().file)) continue;
    const ReferenceEntry* entry = find_reference(scene, stage);
    if (!entry || entry->stage != stage) continue;
    ++scenes;
    const SceneFile file = read_scene(data_folder(scene.sources.front().file));
    REQUIRE(file.scene.has_value());
    const Reference reference = read_reference(renders() / entry->exr.file);
    CHECK(reference.scene == scene.name);
    CHECK(reference.stage == stage);
    const Settings settings{stage, {reference.value.width, reference.value.height}, file.scene->max_bounces, {}};
    check_same(who, scene, stage, render_image(*make(*file.scene, settings), settings.size, 2), reference);
  }
  CHECK(scenes >= 2);
}

void check_images(int stage) { check_stage(stage, "the image", engine_under_test); }

/// A folder of data with one scene and its reference, which hold.
class SmallData {
 public:
  SmallData() {
    write("docs/model.md", "the model");
    write("scenes/ball.toml", "a scene");
    write("reference/renders/01_rays/ball.exr", "floats");
    write("reference/renders/01_rays/ball.png", "a picture");
    manifest_.scenes = {{"ball",
                         {hashed("scenes/ball.toml", "scenes/ball.toml"), hashed("docs/model.md", "docs/model.md")},
                         {{1, hashed("reference/renders/01_rays/ball.exr", "01_rays/ball.exr"),
                           hashed("reference/renders/01_rays/ball.png", "01_rays/ball.png")}}}};
    write_manifest(folder_ / manifest_file, manifest_);
  }

  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((folder_ / file.string()).parent_path());
    std::ofstream(folder_ / file.string()) << text;
  }
  void remove(const std::string& file) const { fs::remove(folder_ / file); }

  /// All complaints, one a line.
  std::string complaints() const {
    std::string text;
    for (const std::string& sentence : broken_promises(folder_ / "", read_manifest(folder_ / manifest_file)))
      text += sentence + "\n";
    return text;
  }

  fs::path manifest_path() const { return folder_ / manifest_file; }

 private:
  HashedFile hashed(const std::string& path, const std::string& name) const { return {name, file_hash(folder_ / path)}; }

  TemporaryFolder folder_;
  Manifest manifest_;
};

}  // namespace

TEST_CASE("stage 1: images are like the references", "[stage1][references]") { check_images(1); }
TEST_CASE("stage 2: images are like the references", "[stage2][references]") { check_images(2); }
TEST_CASE("stage 3: images are like the references", "[stage3][references]") { check_images(3); }
TEST_CASE("stage 4: images are like the references", "[stage4][references]") { check_images(4); }
TEST_CASE("stage 5: images are like the references", "[stage5][references]") { check_images(5); }
TEST_CASE("stage 6: images are like the references", "[stage6][references]") { check_images(6); }
TEST_CASE("stage 7: images are like the references", "[stage7][references]") { check_images(7); }

#ifdef RAYLAB_WITH_ENGINE
TEST_CASE("engine: images are like the references, in double and in float", "[engine][references]") {
  for (const StageInfo& stage : stage_list())
    for (const Precision precision : {Precision::f64, Precision::f32})
      check_stage(stage.number, "the engine",
                  [&](const Scene& scene, const Settings& settings) { return make_fast(scene, settings, {precision}); });
}
#endif

TEST_CASE("references: the manifest holds", "[references]") {
  const Manifest manifest = checked_in();
  const fs::path data = data_folder(manifest_file).parent_path().parent_path().parent_path();
  const std::vector<std::string> broken = broken_promises(data, manifest);
  INFO((broken.empty() ? "" : broken.front()));
  CHECK(broken.empty());
  CHECK(manifest.scenes.size() >= 21);
}

TEST_CASE("references: hard scenes have the last stage only", "[references]") {
  CHECK(is_hard("scenes/hard/telescope.toml"));
  CHECK_FALSE(is_hard("scenes/scene1.toml"));
  CHECK_FALSE(is_hard("scenes/07_ssaa/edges.toml"));
  const Manifest manifest = checked_in();
  REQUIRE(find_scene(manifest, "telescope") != nullptr);
  CHECK(find_scene(manifest, "telescope")->references.size() == 1);
  CHECK(find_reference(*find_scene(manifest, "telescope"), 6) == nullptr);
  CHECK(find_reference(*find_scene(manifest, "telescope"), 7) != nullptr);
}

TEST_CASE("references: a stage that changes nothing is shown by the one before", "[references]") {
  const Manifest manifest = checked_in();
  const SceneEntry* scene = find_scene(manifest, "scene1");
  REQUIRE(scene != nullptr);
  CHECK(find_scene(manifest, "scenes/scene1.toml") == scene);
  CHECK(find_scene(manifest, "scene9") == nullptr);
  REQUIRE(find_reference(*scene, 6) != nullptr);
  CHECK(find_reference(*scene, 6)->stage == 5);  // no glass
  CHECK(find_reference(*scene, 0) == nullptr);
}

TEST_CASE("references: the image of another stage is recognised", "[references]") {
  const Manifest manifest = checked_in();
  REQUIRE(find_scene(manifest, "scene4") != nullptr);
  const SceneEntry& scene = *find_scene(manifest, "scene4");
  const auto text_for = [&](int shown, int wanted) {
    const Reference reference = read_reference(renders() / find_reference(scene, shown)->exr.file);
    const auto finding = find_other_stage(reference.value, NumberFormat::float32, scene, wanted, renders());
    return finding ? finding->text : "";
  };
  CHECK(text_for(4, 5) == "This is what stage 4, shadows, gives: one stage behind.");
  CHECK(text_for(3, 6) == "This is what stage 3, blinn-phong, gives: 3 stages behind.");
  CHECK(text_for(6, 5) == "This is what stage 6, refraction, gives: one stage ahead.");
  CHECK(find_other_stage(Image(160, 120, Color(0.1)), NumberFormat::float32, scene, 5, renders()) == std::nullopt);
}

TEST_CASE("references: what a known mistake looks like is told", "[references]") {
  const Manifest manifest = checked_in();
  REQUIRE(find_scene(manifest, "scene5") != nullptr);
  const SceneEntry& entry = *find_scene(manifest, "scene5");
  const SceneFile file = read_scene(data_folder(entry.sources.front().file));
  const Reference reference = read_reference(renders() / find_reference(entry, 5)->exr.file);
  const Settings settings{5, {reference.value.width, reference.value.height}, file.scene->max_bounces, {}};
  const auto told = [&](std::string_view name) {
    StageTable wrong = table();
    for (const Mistake& mistake : known_mistakes())
      if (mistake.name == name) mistake.put_into(wrong);
    const Image image = render_image(*make_stages(*file.scene, settings, wrong), settings.size, 2);
    const auto findings = find_patterns(image, reference, compare(image, NumberFormat::float64, reference));
    return findings.empty() ? "" : findings.front().text;
  };
  CHECK(told("upside down") == "The image is the reference upside down.");
  CHECK(told("mirrored left to right") == "The image is the reference mirrored left to right.");
  CHECK(told("no half pixel") == "The image is the reference shifted by half a pixel to the left and by half a pixel down.");
  CHECK(told("no shadows") == "");
}

TEST_CASE("manifest: what holds has no complaints, and reads as written", "[references]") {
  const SmallData data;
  CHECK(data.complaints().empty());
  const Manifest manifest = read_manifest(data.manifest_path());
  CHECK(manifest.scenes.at(0).references.at(0).stage == 1);
  CHECK(manifest.scenes.at(0).sources.at(0).file == "scenes/ball.toml");
}

TEST_CASE("manifest: each broken promise has its own message", "[references]") {
  const SmallData changed_model, changed_scene, missing, broken, unlisted, new_scene;
  changed_model.write("docs/model.md", "another model");
  CHECK_THAT(changed_model.complaints(), ContainsSubstring("model.md: has changed since its references were rendered"));
  changed_scene.write("scenes/ball.toml", "another scene");
  CHECK_THAT(changed_scene.complaints(), ContainsSubstring("ball.toml: has changed since its references were rendered"));
  missing.remove("reference/renders/01_rays/ball.exr");
  CHECK_THAT(missing.complaints(), ContainsSubstring("ball.exr: is missing, though the manifest lists it"));
  broken.write("reference/renders/01_rays/ball.exr", "floatz");
  CHECK_THAT(broken.complaints(), ContainsSubstring("ball.exr: is not the file that the manifest lists"));
  unlisted.write("reference/renders/01_rays/cube.exr", "floats");
  CHECK_THAT(unlisted.complaints(), ContainsSubstring("cube.exr: the manifest does not list it"));
  new_scene.write("scenes/02/cube.toml", "a scene");
  CHECK_THAT(new_scene.complaints(), ContainsSubstring("cube.toml: has no references"));
}

TEST_CASE("manifest: what is none says so", "[references]") {
  const SmallData data;
  CHECK_THROWS_WITH(read_manifest("nowhere/manifest.json"), ContainsSubstring("there is no manifest of the references"));
  data.write(manifest_file, "{\"scenes\": 3");
  CHECK_THROWS_WITH(read_manifest(data.manifest_path()), ContainsSubstring("is no manifest of references"));
  data.write(manifest_file, R"({"scenes": [{"name": "x", "sources": [], "references": []}]})");
  CHECK_THROWS_WITH(read_manifest(data.manifest_path()), ContainsSubstring("scene x has no sources"));
  std::string text = bytes_of(SmallData().manifest_path());
  text.replace(text.find("\"stage\": 1"), 10, "\"stage\": 9");
  data.write(manifest_file, text);
  CHECK_THROWS_WITH(read_manifest(data.manifest_path()), ContainsSubstring("scene ball has a reference at stage 9"));
}

TEST_CASE("references: the hash is SHA-1", "[references]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "abc") << "abc";
  CHECK(file_hash(folder / "abc") == "a9993e364706816aba3e25717850c26c9cd0d89d");  // FIPS 180-4's example
  CHECK_THROWS_WITH(file_hash(folder / "none"), ContainsSubstring("cannot be read"));
}
