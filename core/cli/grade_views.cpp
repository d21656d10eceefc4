#include "core/cli/grade_views.hpp"

#include "core/calls/plain_json.hpp"
#include "core/cli/command.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/render_reference.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/partial_file.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/render/render.hpp"
#include "core/render/stage_table.hpp"
#include "core/scene/read_file.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 4096;  // of a camera

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
Camera found_camera(const Scene& own, int stage, const std::string& name, ImageSize size, const std::string& key) {
  constexpr int most_tries = 100;
  const double wanted = share_of_stage(own, stage, size) / 2;
  const std::string what = "grading.toml: the scene '" + name + "' ", which = "stage " + std::to_string(stage);
  if (wanted == 0) throw Failure(what + "shows nothing of " + which, wrong_usage);
  std::mt19937_64 random(std::stoull(key.substr(0, 16), nullptr, 16));
  Scene scene = own;
  for (int k = 0; k < most_tries; ++k) {
    scene.camera = drawn_camera(own, random);
    if (share_of_stage(scene, stage, size) >= wanted) return scene.camera;
  }
  throw Failure(what + "shows " + which + " from no camera that was drawn", wrong_usage);
}

/// A view from a drawn camera. Camera and reference follow from what is hashed, and are kept in the folder under that.
View drawn_view(const SceneEntry& entry, int stage, ImageSize size, const std::string& seed, const fs::path& folder) {
  const std::string key =
      text_hash(seed + ' ' + std::to_string(stage) + ' ' + entry.name + ' ' + std::to_string(size.width) + 'x' +
                std::to_string(size.height) + ' ' + entry.sources.front().hash);
  const fs::path stem = folder / ("stage" + std::to_string(stage) + "-" + entry.name + "-" + key.substr(0, 8));
  const fs::path camera = stem.string() + ".json", reference = stem.string() + ".exr";
  View view{stage, entry.name, true, Known::load(entry), {}};
  if (const FileText kept = read_file(camera, most_bytes); kept.text) {
    view.scene.camera = from_json<Camera>(*kept.text);
  } else {
    view.scene.camera = found_camera(view.scene, stage, entry.name, size, key);
    write_file(camera, to_json(view.scene.camera));
  }
  if (!fs::exists(reference)) write_reference(reference, oracle_reference({view.name, {}, view.scene}, stage, size, 1, 0));
  view.reference = read_reference(reference);
  return view;
}

}  // namespace

std::vector<View> grading_views(const Grading& grading, const std::string& seed, const fs::path& folder) {
  const Known known;
  std::vector<View> views;
  for (const StageInfo& stage : stage_list()) {
    const StageGrading& plan = grading.stages[static_cast<std::size_t>(stage.number - 1)];
    if (!plan.shown.empty()) views.push_back(known.published(stage.number, plan.shown));
    for (const std::string& name : plan.scenes)
      views.push_back(drawn_view(known.scene(name), stage.number, grading.size, seed, folder));
  }
  return views;
}

}  // namespace raylab::cli
