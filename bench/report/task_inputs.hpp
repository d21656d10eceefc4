#pragma once

#include "bench/report/task_errors.hpp"
#include "core/render/stage_table.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace raylab::bench {

/// Inputs of one kind for a task.
template <class Function>
struct Family {
  std::string name;  ///< "ordinary", "far tiny spheres"
  bool hard;         ///< rounding does more harm here than elsewhere, or a textbook's formula fails
  std::string text;  ///< one sentence: what these inputs are, and why they are hard
  std::vector<Arguments<Function>> inputs;
};

/// The families of each task, "ordinary" first; none for a task of a later stage than the seventh.
struct TaskFamilies {
#define RAYLAB_MEMBER(label, function, summary, example) std::vector<Family<decltype(&contract::function)>> function;
  RAYLAB_TASKS(RAYLAB_MEMBER)
#undef RAYLAB_MEMBER
};

/// Families of `count` random inputs: the same ones on every run and machine, and with a larger count the same ones first.
/// All fit their task's contract, vectors that are to be unit being so to a rounding, and lie in the range of a float. A
/// family has fewer inputs where each is a long list, and one where the task takes none.
TaskFamilies task_families(std::size_t count);

/// Calls visit(label, name, summary, families, member) for each task: `families` those of the task, `member` its place in a
/// StageTable.
template <class Visit>
void for_each_task(const TaskFamilies& families, Visit visit) {
#define RAYLAB_VISIT(label, function, summary, example) \
  visit(label, #function, summary, families.function, &StageTable::function);
  RAYLAB_TASKS(RAYLAB_VISIT)
#undef RAYLAB_VISIT
}

}  // namespace raylab::bench
