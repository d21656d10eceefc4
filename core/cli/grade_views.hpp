#pragma once

#include "core/grade/grading.hpp"
#include "core/grade/view.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::cli {

/// The images that submissions are asked for: of each stage the published one, and the hidden ones from cameras that are
/// drawn with `seed`. References of the hidden ones are the oracle's; they are kept in `folder`, and taken from there.
/// Throws Failure if a scene is not known or shows too little of its stage, and Cancelled on Ctrl-C.
std::vector<View> grading_views(const Grading& grading, const std::string& seed, const std::filesystem::path& folder);

}  // namespace raylab::cli
