#pragma once

#include "core/image/diff.hpp"
#include "core/references/manifest.hpp"

#include <filesystem>
#include <optional>

namespace raylab {

/// "This is what stage 4, shadows, gives: one stage behind", if an image that is not what its reference shows is the same as
/// the reference of another stage of that scene. `renders` is the folder of the manifest.
std::optional<Finding> find_other_stage(const Image& image, NumberFormat format, const SceneEntry& scene, int stage,
                                        const std::filesystem::path& renders);

}  // namespace raylab
