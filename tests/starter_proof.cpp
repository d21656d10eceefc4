// Proves of each task that its starter fails the task's own tests and no earlier task's: the tests notice that it is not
// written, and nothing before it depends on it.

#include "core/render/stage_table.hpp"
#include "tests/runner.hpp"
#include "tests/selection.hpp"
#include "tests/temporary_folder.hpp"

#include <iostream>
#include <string>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();
extern "C" const raylab::ExportedTasks* raylab_tasks_starter();

using namespace raylab;

namespace {

/// Every test of the task must fail, and say which task is missing, and where.
bool fails_its_own(const TaskInfo& task, const StageTable& table, const std::filesystem::path& report) {
  const test::Totals totals = test::run_tests(test::tests_of(task.label), table, report);
  const std::string folder(stage_info(stage_of(task.label)).folder);
  const std::string message = "task " + std::string(task.label) + " is not written yet: stages/" + folder + "/starter.cpp:";
  return totals.passed == 0 && totals.failed > 0 && test::bytes_of(report).find(message) != std::string::npos;
}

}  // namespace

int main() {
  const StageTable solution = import_tasks(*raylab_tasks_solution());
  const StageTable starter = import_tasks(*raylab_tasks_starter());
  const test::TemporaryFolder folder;
  std::size_t passed = 0, failed = 0;
  const auto check = [&](bool holds, const std::string& what) {
    ++(holds ? passed : failed);
    if (!holds) std::cout << "FAILED: " << what << '\n';
  };

  for (const TaskInfo& task : task_list()) {
    const std::string label(task.label);
    StageTable table = solution;
    mix(table, starter, task.label);
    check(fails_its_own(task, table, folder / "report"), "the starter of " + label + " fails all tests of " + label);
    const std::string earlier = test::tests_before(task.label);
    if (earlier.empty()) continue;
    const test::Totals before = test::run_tests(earlier, table, folder / "report");
    check(before.failed == 0 && before.passed > 0, "the starter of " + label + " fails no earlier task's test");
  }
  std::cout << passed << " passed, " << failed << " failed\n";
  return failed == 0 ? 0 : 1;
}
