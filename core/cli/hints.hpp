#pragma once

#include "core/explain/first_difference.hpp"

#include <CLI/CLI.hpp>

#include <string_view>
#include <vector>

namespace raylab::cli {

/// Adds --hint, which sets `level`: 0 if it is not given.
void add_hint_option(CLI::App& command, int& level);

/// Prints the hints on somebody's tasks up to that level; nothing for level 0, and no more than the course allows by
/// RAYLAB_HINTS in the environment.
void print_hints(const AskTask& ask, const std::vector<std::string_view>& labels, int level);

/// The highest level that the course allows: 3, or what RAYLAB_HINTS in the environment says. Throws Failure if that is no
/// level.
int highest_hint();

}  // namespace raylab::cli
