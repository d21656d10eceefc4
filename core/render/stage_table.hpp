#pragma once

#include "core/math/seen.hpp"
#include "core/math/task_export.hpp"
#include "stages/stages.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// The place of each task in task_list(), and how many there are.
enum class TaskIndex : std::size_t {
#define RAYLAB_INDEX(label, function, summary, example) function,
  RAYLAB_TASKS(RAYLAB_INDEX)
#undef RAYLAB_INDEX
      count
};

/// One function for each task of every stage: all that the driver and the tests know of an implementation.
struct StageTable {
#define RAYLAB_MEMBER(label, function, summary, example) decltype(&contract::function) function = nullptr;
  RAYLAB_TASKS(RAYLAB_MEMBER)
#undef RAYLAB_MEMBER
};

struct TaskInfo {
  std::string_view label;    ///< "5.1"
  std::string_view name;     ///< the function's: "reflect"
  std::string_view summary;  ///< "the mirror image of a direction"
  std::string_view example;  ///< arguments of a call, JSON, in order: R"({"d": [0.6, -0.8, 0], "n": [0, 1, 0]})"
};

struct StageInfo {
  int number;               ///< from 1
  std::string_view name;    ///< "blinn-phong"
  std::string_view folder;  ///< in every tree: "03_blinn_phong"
};

/// All stages and all tasks, in order.
std::span<const StageInfo> stage_list();
std::span<const TaskInfo> task_list();

/// The stage of that number, which must exist.
const StageInfo& stage_info(int number);

/// "stage 4, shadows".
std::string stage_title(int number);

/// The task with that label, which must exist.
const TaskInfo& task_info(std::string_view label);

/// Does a selection name the task: a task, "5.1", a stage, "4", or stages, "1-3"?
bool selects(std::string_view selection, std::string_view task_label);

/// The number of the stage that a task belongs to: 5 for "5.1".
int stage_of(std::string_view task_label);

/// The table of an implementation's exported tasks. Throws std::runtime_error if they were built for other contracts or one
/// is missing.
StageTable import_tasks(const ExportedTasks& exported);

/// The same of an implementation of some tasks only: the others are null.
StageTable import_some_tasks(const ExportedTasks& exported);

/// Puts the tasks of `other` that `selection` names into `table`.
/// Throws std::invalid_argument if there is no such stage or task.
void mix(StageTable& table, const StageTable& other, std::string_view selection);

/// The ray filters of `table` up to and including stage `last_stage`.
std::vector<RayFilter> ray_filters(const StageTable& table, int last_stage);

}  // namespace raylab
