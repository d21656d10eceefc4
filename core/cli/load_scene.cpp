#include "core/cli/load_scene.hpp"

#include "core/cli/command.hpp"
#include "core/scene/read_scene.hpp"

#include <algorithm>
#include <iostream>
#include <string>

namespace raylab::cli {

Scene load_scene(const std::filesystem::path& path) {
  SceneFile file = read_scene(path);
  for (const Diagnostic& diagnostic : file.diagnostics) std::cerr << to_string(diagnostic) << '\n';
  if (file.scene) return std::move(*file.scene);
  const auto mistakes = std::count_if(file.diagnostics.begin(), file.diagnostics.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Diagnostic::Severity::error;
  });
  throw Failure(path.string() + ": " + std::to_string(mistakes) + (mistakes == 1 ? " mistake" : " mistakes"));
}

}  // namespace raylab::cli
