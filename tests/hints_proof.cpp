// Proves that each known mistake gets the hint with its name, at its task; that a right table gets none, a mistake that is
// not known no name, and two mistakes in different tasks both. Exit code 1 if a statement does not hold.

#include "core/calls/call_task.hpp"
#include "tests/hints/hints.hpp"
#include "tests/mistakes/mistakes.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();

using namespace raylab;
using namespace raylab::test;

namespace {

int passed = 0, failed = 0;

void check(bool holds, const std::string& what) {
  ++(holds ? passed : failed);
  if (!holds) std::cerr << "FAILED: " << what << '\n';
}

AskTask asking(const StageTable& table) {
  return [table](const TaskInfo& task, const std::string& arguments) { return TaskCaller(table, task).result(arguments); };
}

/// The probes of one stage's tasks.
Probes of_stage(const Probes& all, int stage) {
  Probes some;
  std::copy_if(all.begin(), all.end(), std::inserter(some, some.end()),
               [&](const auto& probes) { return stage_of(probes.first) == stage; });
  return some;
}

std::string names(const std::vector<Hint>& hints) {
  std::string text;
  for (const Hint& hint : hints) text += " [" + std::string(hint.task->label) + " " + hint.mistake + "]";
  return text;
}

/// Answers that a right program in float may give too.
bool within_rounding(const Mistake& mistake) {
  return mistake.task == "6.2" && mistake.name == "a cosine beyond 1 not clamped";
}

void check_mistake(const Mistake& mistake, const StageTable& right, const Probes& probes) {
  if (mistake.shows == Shows::nowhere) return;
  const std::vector<Hint> hints = find_hints(right, asking(with(mistake, right)), of_stage(probes, stage_of(mistake.task)));
  const std::string title = std::string(mistake.task) + " " + std::string(mistake.name);
  if (within_rounding(mistake)) {
    check(hints.empty(), title + ": differs by less than float rounding, and gets" + names(hints));
    return;
  }
  check(hints.size() == 1 && hints[0].task->label == mistake.task,
        title + ": wanted one hint, at its task, got" + names(hints));
  check(!hints.empty() && hints[0].mistake.find(mistake.name) != std::string::npos, title + ": is called" + names(hints));
  if (!hints.empty() && hints[0].mistake != mistake.name) std::cout << title << ": not told apart:" << names(hints) << '\n';
}

}  // namespace

int main() {
  const StageTable right = import_tasks(*raylab_tasks_solution());
  std::vector<std::string_view> labels;
  for (const TaskInfo& task : task_list()) labels.push_back(task.label);
  const Probes probes = find_probes(right, labels);
  for (const auto& [label, inputs] : probes) check(!inputs.empty(), std::string(label) + " has no probes");

  check(find_hints(right, asking(right), probes).empty(), "a right table gets a hint");
  for (const Mistake& mistake : known_mistakes()) check_mistake(mistake, right, probes);

  StageTable unknown = right;
  unknown.reflect = [](const Vec3& d, const Vec3& n) { return d - 1.75 * dot(d, n) * n; };
  const std::vector<Hint> none = find_hints(right, asking(unknown), probes);
  check(none.size() == 1 && none[0].task->label == "5.1" && none[0].mistake.empty() && !none[0].observed.empty(),
        "a mistake that is not known is called" + names(none));

  StageTable two = right;
  two.specular_weight = [](double) { return 1.0; };
  two.go_on = [](int bounce, int max_bounces, double weight) { return bounce < max_bounces && weight != 0; };
  const std::vector<Hint> both = find_hints(right, asking(two), probes);
  check(both.size() == 2 && both[0].task->label == "3.1" && both[1].task->label == "5.3", "two mistakes get" + names(both));

  std::cerr << passed << " passed, " << failed << " failed\n";
  return failed == 0 ? 0 : 1;
}
