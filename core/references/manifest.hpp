#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// A file and the SHA-1 of its bytes.
struct HashedFile {
  std::string file;
  std::string hash;
};

/// The checked-in renders of a scene at one stage; files are relative to the manifest's folder.
struct ReferenceEntry {
  int stage = 0;
  HashedFile exr;  ///< the oracle's word: see core/image/reference_file.hpp
  HashedFile png;  ///< larger, for people
};

struct SceneEntry {
  std::string name;                        ///< "scene3"
  std::vector<HashedFile> sources;         ///< the scene file, its tables, the model; relative to the data folder
  std::vector<ReferenceEntry> references;  ///< one for each stage that changes the image, in order
};

/// What is checked in, and what it was made from: reference/renders/manifest.json.
struct Manifest {
  std::vector<SceneEntry> scenes;
};

inline const std::string manifest_file = "reference/renders/manifest.json";

/// Reads a manifest. Throws std::runtime_error, "PATH: what is wrong".
Manifest read_manifest(const std::filesystem::path& path);

/// Writes it, whole or not at all. Throws std::runtime_error.
void write_manifest(const std::filesystem::path& path, const Manifest& manifest);

/// The files that a scene's references were made from and that have changed since, one sentence each.
std::vector<std::string> changed_sources(const std::filesystem::path& data, const SceneEntry& scene);

/// The files of a reference that are missing or not those that the manifest lists, one sentence each.
std::vector<std::string> broken_files(const std::filesystem::path& renders, const ReferenceEntry& reference);

/// Everything in which the manifest of a data folder does not hold, one sentence each: files that are missing, changed, or
/// lie there unlisted; sources that changed since; scenes without references.
std::vector<std::string> broken_promises(const std::filesystem::path& data, const Manifest& manifest);

/// The entry of a scene, by its name ("scene3") or file ("scenes/scene3.toml"); null if there is none.
const SceneEntry* find_scene(const Manifest& manifest, std::string_view scene);

/// Is a scene file, relative to the data folder, one of scenes/hard? Those compare arithmetic: no tolerance is calibrated
/// and nobody is graded with them, and their only references are those of the last stage.
bool is_hard(const std::filesystem::path& scene);

/// The last reference up to a stage: later stages do not change the image. Null if there is none.
const ReferenceEntry* find_reference(const SceneEntry& scene, int stage);

}  // namespace raylab
