#include "core/cli/grade_views.hpp"

#include "core/calls/plain_json.hpp"
#include "core/cli/command.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/render_reference.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/render/render.hpp"
#include "core/render/stage_table.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

/// Known scenes, and where their references lie.
class Known {
 public:
  Known() : file_(data_folder(manifest_file)), manifest_(read_manifest(file_)) {}

  const SceneEntry& scene(const std::string& name) const {
    if (const SceneEntry* entry = find_scene(manifest_, name)) return *entry;
    std::string names;
    for (const SceneEntry& entry : manifest_.scenes) names += " " + entry.name;
    throw Failure("grading.toml: there is no scene '" + name + "'. There are:" + names, wrong_usage);
  }

  View published(int stage, const std::string& name) const {
    const SceneEntry& entry = scene(name);
    const ReferenceEntry* reference = find_reference(entry, stage);
    if (!reference) throw Failure("grading.toml: the scene '" + name + "' has no reference", wrong_usage);
    return {stage, name, false, load(entry), read_reference(file_.parent_path() / reference->exr.file)};
  }

  static Scene load(const SceneEntry& entry) { return load_scene(data_folder(entry.sources.front().file)); }

 private:
  fs::path file_;
  Manifest manifest_;
};

Image quick(const Scene& scene, int stage, ImageSize size) {
  const Settings settings{stage, size, scene.max_bounces, {}};
  return render_image(*make_fast(scene, settings, {Precision::f64}), size, 1);
}

/// The share of an image's pixels in which the stage makes a difference, by more than a step of 255.
double share_of_stage(const Scene& scene, int stage, ImageSize size) {
  const Image now = quick(scene, stage, size);
  const Image before = stage > 1 ? quick(scene, stage - 1, size) : Image(size.width, size.height);
  std::size_t changed = 0;
  for (std::size_t k = 0; k < now.pixels.size(); ++k) {
    const Color d = now.pixels[k] - before.pixels[k];
    if (std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) > 1. / 255) ++changed;
  }
  return static_cast<double>(changed) / static_cast<double>(now.pixels.size());
}

/// Draws cameras until one shows what its stage is about, at least half as well as the scene's own.
View drawn_view(const Known& known, int stage, const std::string& name, ImageSize size, const std::string& seed) {
  constexpr int most_tries = 100;
  View view{stage, name, true, known.load(known.scene(name)), {}};
  const Scene own = view.scene;
  const double wanted = share_of_stage(own, stage, size) / 2;
  if (wanted == 0)
    throw Failure("grading.toml: the scene '" + name + "' shows nothing of stage " + std::to_string(stage), wrong_usage);
  const std::string digits = text_hash(seed + " " + std::to_string(stage) + " " + name).substr(0, 16);
  std::mt19937_64 random(std::stoull(digits, nullptr, 16));
  for (int k = 0; k < most_tries; ++k) {
    view.scene.camera = drawn_camera(own, random);
    if (share_of_stage(view.scene, stage, size) >= wanted) return view;
  }
  throw Failure("grading.toml: no camera shows stage " + std::to_string(stage) + " in the scene '" + name + "'",
                wrong_usage);
}

/// One of the oracle's making.
Reference reference_of(const View& view, ImageSize size, const fs::path& file) {
  if (!fs::exists(file)) write_reference(file, oracle_reference({view.name, {}, view.scene}, view.stage, size, 1, 0));
  return read_reference(file);
}

}  // namespace

std::vector<View> grading_views(const Grading& grading, const std::string& seed, const fs::path& folder) {
  const Known known;
  std::vector<View> views;
  for (const StageInfo& stage : stage_list()) {
    const StageGrading& plan = grading.stages[static_cast<std::size_t>(stage.number - 1)];
    if (!plan.shown.empty()) views.push_back(known.published(stage.number, plan.shown));
    for (const std::string& name : plan.scenes) {
      View view = drawn_view(known, stage.number, name, grading.size, seed);
      const std::string what =
          seed + to_json(view.scene.camera) + std::to_string(grading.size.width) + "x" + std::to_string(grading.size.height);
      const std::string file =
          "stage" + std::to_string(stage.number) + "-" + name + "-" + text_hash(what).substr(0, 8) + ".exr";
      view.reference = reference_of(view, grading.size, folder / file);
      views.push_back(std::move(view));
    }
  }
  return views;
}

}  // namespace raylab::cli
