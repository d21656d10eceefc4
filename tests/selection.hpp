#pragma once

#include "core/render/stage_table.hpp"

#include <string>
#include <string_view>

namespace raylab::test {

/// The selection of a task's tests, for run_tests(): "[5.1]".
inline std::string tests_of(std::string_view task) { return "[" + std::string(task) + "]"; }

/// Those of them that a submission is asked: not the numerically hard ones, which ask for more than a right answer.
inline std::string tests_of_submission(std::string_view task) { return tests_of(task) + "~[hard]"; }

/// The selection of the tests of all tasks before this one; empty for the first.
inline std::string tests_before(std::string_view task) {
  std::string earlier;
  for (const TaskInfo& other : task_list()) {
    if (other.label == task) break;
    earlier += (earlier.empty() ? "" : ",") + tests_of(other.label);
  }
  return earlier;
}

/// The selection of what a submission is asked of all other tasks.
inline std::string tests_of_submission_besides(std::string_view task) {
  std::string others;
  for (const TaskInfo& other : task_list())
    if (other.label != task) others += (others.empty() ? "" : ",") + tests_of_submission(other.label);
  return others;
}

}  // namespace raylab::test
