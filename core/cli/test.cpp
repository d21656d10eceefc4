#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#ifdef RAYLAB_WITH_TESTS
#include "tests/runner.hpp"
#endif

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>

namespace raylab::cli {
namespace {

/// The tag of the tests that a user asks for: "5.1", "5" or "reflections"; nothing selects all tests.
std::string tag_of(const std::string& selection) {
  if (selection.empty()) return "";
  const auto tasks = task_list();
  if (std::any_of(tasks.begin(), tasks.end(), [&](const TaskInfo& task) { return task.label == selection; }))
    return "[" + selection + "]";
  try {
    return "[stage" + std::to_string(find_stage(selection).number) + "]";
  } catch (const CLI::ValidationError&) {
    throw Failure("there is no stage or task '" + selection + "': 'raylab stages' lists them", wrong_usage);
  }
}

}  // namespace

void add_test(CLI::App& app) {
  CLI::App* command = app.add_subcommand("test", "Run the tests of a stage, of a task or all");
  const auto selection = std::make_shared<std::string>();
  command->add_option("STAGE|TASK", *selection, "A stage (5, reflections) or a task (5.1); default: all tests");
  command->footer(
      "Exit code: 0 all passed, 1 some failed, 2 there is no such stage or task.\n\n"
      "Examples:\n  raylab test\n  raylab test 5\n  raylab test 5.1");
  command->callback([selection] {
    const std::string tag = tag_of(*selection);
#ifdef RAYLAB_WITH_TESTS
    const test::Totals totals = test::run_tests(tag, solution_table());
    if (totals.passed + totals.failed == 0) throw Failure("no test is tagged " + tag, wrong_usage);
    std::cout << totals.passed << " passed, " << totals.failed << " failed\n";
    if (totals.failed > 0) throw Failure(std::to_string(totals.failed) + " tests failed");
#else
    (void)tag;
    throw Failure("the tests were left out when this raylab was built", wrong_usage);
#endif
  });
}

}  // namespace raylab::cli
