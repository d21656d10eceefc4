#include "core/references/manifest.hpp"

#include "core/image/file_hash.hpp"
#include "core/image/partial_file.hpp"
#include "core/render/stage_table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>

namespace raylab {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

const std::string update_hint = ": run 'raylab reference --update'";

Json to_json(const HashedFile& file) { return {{"file", file.file}, {"sha1", file.hash}}; }

HashedFile hashed_file(const Json& json) { return {json.at("file"), json.at("sha1")}; }

Json to_json(const SceneEntry& scene) {
  Json sources = Json::array();
  for (const HashedFile& source : scene.sources) sources.push_back(to_json(source));
  Json references = Json::array();
  for (const ReferenceEntry& entry : scene.references)
    references.push_back({{"stage", entry.stage}, {"exr", to_json(entry.exr)}, {"png", to_json(entry.png)}});
  return {{"name", scene.name}, {"sources", sources}, {"references", references}};
}

SceneEntry scene_entry(const Json& json) {
  SceneEntry scene{json.at("name"), {}, {}};
  for (const Json& source : json.at("sources")) scene.sources.push_back(hashed_file(source));
  if (scene.sources.empty()) throw std::runtime_error("scene " + scene.name + " has no sources");
  for (const Json& entry : json.at("references")) {
    const int stage = entry.at("stage");
    if (stage < 1 || stage > static_cast<int>(stage_list().size()))
      throw std::runtime_error("scene " + scene.name + " has a reference at stage " + std::to_string(stage));
    scene.references.push_back({stage, hashed_file(entry.at("exr")), hashed_file(entry.at("png"))});
  }
  return scene;
}

/// The sentence that says how a file differs from what the manifest promises, or nothing.
void check_file(const fs::path& folder, const HashedFile& promised, const std::string& changed,
                std::vector<std::string>& broken) {
  const fs::path path = folder / promised.file;
  if (!fs::is_regular_file(fs::symlink_status(path)))
    broken.push_back(path.string() + ": is missing, though the manifest lists it" + update_hint);
  else if (file_hash(path) != promised.hash)
    broken.push_back(path.string() + ": " + changed + update_hint);
}

void check_unlisted(const fs::path& renders, const std::set<fs::path>& listed, std::vector<std::string>& broken) {
  for (const auto& entry : fs::recursive_directory_iterator(renders))
    if (entry.is_regular_file() && !listed.contains(entry.path().lexically_relative(renders)))
      broken.push_back(entry.path().string() +
                       ": the manifest does not list it: remove it, or run 'raylab reference --update'");
}

void check_scenes(const fs::path& data, const Manifest& manifest, std::vector<std::string>& broken) {
  for (const auto& entry : fs::recursive_directory_iterator(data / "scenes"))
    if (entry.path().extension() == ".toml" &&
        find_scene(manifest, entry.path().lexically_relative(data).string()) == nullptr)
      broken.push_back(entry.path().string() + ": has no references" + update_hint);
}

}  // namespace

Manifest read_manifest(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": there is no manifest of the references" + update_hint);
  try {
    const Json json = Json::parse(file);
    Manifest manifest;
    for (const Json& scene : json.at("scenes")) manifest.scenes.push_back(scene_entry(scene));
    return manifest;
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": is no manifest of references: " + error.what());
  }
}

void write_manifest(const fs::path& path, const Manifest& manifest) {
  Json scenes = Json::array();
  for (const SceneEntry& scene : manifest.scenes) scenes.push_back(to_json(scene));
  write_file(path, [&](std::ostream& stream) { stream << Json{{"scenes", scenes}}.dump(1) << '\n'; });
}

std::vector<std::string> changed_sources(const fs::path& data, const SceneEntry& scene) {
  std::vector<std::string> changed;
  for (const HashedFile& source : scene.sources)
    check_file(data, source, "has changed since its references were rendered", changed);
  return changed;
}

std::vector<std::string> broken_files(const fs::path& renders, const ReferenceEntry& reference) {
  std::vector<std::string> broken;
  for (const HashedFile& file : {reference.exr, reference.png})
    check_file(renders, file, "is not the file that the manifest lists", broken);
  return broken;
}

std::vector<std::string> broken_promises(const fs::path& data, const Manifest& manifest) {
  std::vector<std::string> broken;
  const fs::path renders = data / fs::path(manifest_file).parent_path();
  std::set<fs::path> listed{fs::path(manifest_file).filename(), "README.md"};
  for (const SceneEntry& scene : manifest.scenes) {
    for (const std::string& sentence : changed_sources(data, scene))
      if (std::find(broken.begin(), broken.end(), sentence) == broken.end()) broken.push_back(sentence);
    for (const ReferenceEntry& entry : scene.references) {
      const std::vector<std::string> sentences = broken_files(renders, entry);
      broken.insert(broken.end(), sentences.begin(), sentences.end());
      listed.insert({entry.exr.file, entry.png.file});
    }
  }
  check_unlisted(renders, listed, broken);
  check_scenes(data, manifest, broken);
  return broken;
}

const SceneEntry* find_scene(const Manifest& manifest, std::string_view scene) {
  const auto found = std::find_if(manifest.scenes.begin(), manifest.scenes.end(), [&](const SceneEntry& entry) {
    return entry.name == scene || entry.sources.front().file == scene;
  });
  return found == manifest.scenes.end() ? nullptr : &*found;
}

bool is_hard(const fs::path& scene) { return scene.parent_path() == fs::path("scenes") / "hard"; }

const ReferenceEntry* find_reference(const SceneEntry& scene, int stage) {
  const ReferenceEntry* last = nullptr;
  for (const ReferenceEntry& entry : scene.references)
    if (entry.stage <= stage) last = &entry;
  return last;
}

}  // namespace raylab
