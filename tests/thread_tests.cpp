// The tests that start threads, in a program of their own: the thread sanitizer has nothing to see in the others.

#include "core/render/stage_table.hpp"
#include "tests/runner.hpp"

#include <iostream>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();

int main() {
  const raylab::test::Totals totals = raylab::test::run_tests("", raylab::import_tasks(*raylab_tasks_solution()));
  std::cout << totals.passed << " passed, " << totals.failed << " failed\n";
  return totals.passed > 0 && totals.failed == 0 ? 0 : 1;
}
