#pragma once

#include "core/scene/diagnostic.hpp"
#include "core/scene/scene.hpp"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace raylab {

/// What a scene file holds, and what was found in it.
struct SceneFile {
  std::optional<Scene> scene;  ///< empty if there is any error
  /// Mistakes and warnings, in the order of the file; those in the tables of its clouds follow, table by table.
  std::vector<Diagnostic> diagnostics;
  std::vector<std::filesystem::path> tables = {};  ///< the files of its clouds, as far as they could be read, in file order
};

/// Reads a scene file and the cloud tables beside it. The format, with its defaults and ranges, is in docs/model.md, "Scene
/// files (TOML)". All mistakes are found in one run; only a syntax error ends it. Never throws for what a file holds.
SceneFile read_scene(const std::filesystem::path& path);

/// The same from text. `name` stands for the file in messages, and cloud tables are looked for in its folder.
SceneFile parse_scene(std::string_view toml, const std::filesystem::path& name);

}  // namespace raylab
