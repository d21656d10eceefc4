#pragma once

#include "core/explain/first_difference.hpp"
#include "core/render/stage_table.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace raylab::test {

/// An answer to a call, JSON, or what was thrown in its place.
struct Answer {
  std::string json;
  std::string error;
};

/// As answers_agree(); where there is no answer, any error is like another.
bool alike(const Answer& a, const Answer& b);

/// The answers to these inputs of a task.
std::vector<Answer> answers(const TaskInfo& task, const std::vector<std::string>& inputs, const AskTask& ask);
std::vector<Answer> answers(const TaskInfo& task, const std::vector<std::string>& inputs, const StageTable& table);

/// Inputs of tasks, JSON, by label.
using Probes = std::map<std::string_view, std::vector<std::string>>;

/// Probes for these tasks: some of what their own unit tests ask, chosen so that known mistakes give other answers than the
/// solution, and than one another. Runs unit tests, with nothing printed: not while others run.
Probes find_probes(const StageTable& solution, const std::vector<std::string_view>& labels);

}  // namespace raylab::test
