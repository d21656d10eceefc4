#pragma once

#include "core/explain/first_difference.hpp"
#include "tests/hints/probes.hpp"

#include <string>
#include <vector>

namespace raylab::test {

/// What can be said to somebody whose task answers wrongly, in three levels.
struct Hint {
  const TaskInfo* task;
  std::string observed;  ///< 1: what is seen
  std::string look;      ///< 2: where to look
  std::string mistake;   ///< 3: what the mistake is called; empty if no known one answers alike
};

/// The hints on tasks that answer some probe differently from the solution. A known mistake is named where all answers are
/// as it gives them; one in a task that others build on is named once. probes: find_probes()'s; their tasks are asked about,
/// in order.
std::vector<Hint> find_hints(const StageTable& solution, const AskTask& ask, const Probes& probes);

/// The hints as text, up to this level.
std::string hints_text(const std::vector<Hint>& hints, int level);

}  // namespace raylab::test
