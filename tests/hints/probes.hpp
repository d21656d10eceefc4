#pragma once

#include "core/render/stage_table.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace raylab::test {

/// Inputs of tasks, JSON, by label: all that the tasks' own unit tests ask of the solution, which is what tells mistakes
/// apart from it and from one another.
using Probes = std::map<std::string_view, std::vector<std::string>>;

/// Of these tasks. Runs unit tests, with nothing printed: not while others run.
Probes find_probes(const StageTable& solution, const std::vector<std::string_view>& labels);

}  // namespace raylab::test
