#pragma once

#include "core/scene/scene.hpp"

#include <filesystem>

namespace raylab::cli {

/// The scene of a file. Its warnings and mistakes go to standard error; throws Failure if there is any mistake.
Scene load_scene(const std::filesystem::path& path);

}  // namespace raylab::cli
