#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/hints.hpp"
#include "core/cli/watched_render.hpp"
#include "core/submission/remote_table.hpp"
#include "core/submission/worker_engine.hpp"
#ifdef RAYLAB_WITH_TESTS
#include "tests/runner.hpp"
#include "tests/selection.hpp"
#endif

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace raylab::cli {
namespace {

struct Test {
  std::string selection;
  WithOptions submissions;
  int hint = 0;
};

/// The stages that a selection asks for, first to last.
std::pair<int, int> stages_of(const std::string& selection) {
  if (selection.empty()) return {1, stage_list().back().number};
  const auto tasks = task_list();
  const auto task = std::find_if(tasks.begin(), tasks.end(), [&](const TaskInfo& t) { return t.label == selection; });
  const int stage = task != tasks.end() ? stage_of(task->label) : find_stage(selection).number;
  return {stage, stage};
}

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

/// The tasks of what is chosen of submissions, as far as `selection` asks for them.
std::vector<std::string_view> labels_of(const std::vector<Chosen>& submissions, const std::string& selection) {
  const auto [first, last] = stages_of(selection);
  std::vector<std::string_view> labels;
  for (const TaskInfo& task : task_list()) {
    const int stage = stage_of(task.label);
    const auto has_it = [&](const Chosen& chosen) {
      const std::vector<std::string> tasks = chosen_tasks(chosen, stage);
      return stage_files(chosen.folder).contains(stage) && std::find(tasks.begin(), tasks.end(), task.label) != tasks.end();
    };
    if (stage >= first && stage <= last && (selection.find('.') == std::string::npos || selection == task.label) &&
        std::any_of(submissions.begin(), submissions.end(), has_it))
      labels.push_back(task.label);
  }
  return labels;
}

/// The tests of what is chosen of submissions, as far as `selection` asks for it: the unit tests of each task, and of each
/// stage its images. Without the numerically hard cases, which ask for more than a right answer.
std::string tags_of(const std::vector<Chosen>& submissions, const std::string& selection) {
  const bool one_task = selection.find('.') != std::string::npos;
  std::set<std::string> tags;
  for (const std::string_view label : labels_of(submissions, selection)) {
    tags.insert(test::tests_of_submission(label));
    if (!one_task) tags.insert("[stage" + std::to_string(stage_of(label)) + "][references]");
  }
  std::string all;
  for (const std::string& tag : tags) all += (all.empty() ? "" : ",") + tag;
  if (all.empty()) throw Failure("--with names nothing of " + selection, wrong_usage);
  return all;
}

#ifdef RAYLAB_WITH_TESTS
/// Those of the tasks whose own tests failed, whose names begin with the label; all if none did, but an image.
std::vector<std::string_view> failed_tasks(const std::vector<std::string_view>& labels, const test::Totals& totals) {
  std::vector<std::string_view> failed;
  for (const std::string_view label : labels)
    if (std::any_of(totals.failures.begin(), totals.failures.end(),
                    [&](const std::string& test) { return test.starts_with(std::string(label) + " "); }))
      failed.push_back(label);
  return failed.empty() ? labels : failed;
}

/// Catch2 has signal handlers of its own while a test runs. They end the run, and then hand the signal on to this one.
extern "C" void end_interrupted(int) { std::_Exit(interrupted); }

test::Totals run(const Test& test) {
  const std::string tag = tag_of(test.selection);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, end_interrupted);
  if (test.submissions.with.empty() && test.hint > 0) throw Failure("--hint goes with --with", wrong_usage);
  if (test.submissions.with.empty()) return test::run_tests(tag, solution_table());
  const std::vector<Chosen> chosen = chosen_submissions(test.submissions);
  const auto [first, last] = stages_of(test.selection);
  const WorkerSetup setup = build_with(test.submissions, first, last, false);
  RemoteTable remote(setup);
  const auto images = [&](const Scene& scene, const Settings& settings) {
    return make_worker_engine(scene, settings, setup, thread_count(0), tell_stand_in);
  };
  const test::Totals totals =
      test::tell_tests(tags_of(chosen, test.selection), remote.table(), images, setup.with, std::cout);
  if (totals.failed > 0) {
    const AskTask ask = [&](const TaskInfo& task, const std::string& arguments) { return remote.ask(task, arguments); };
    print_hints(ask, failed_tasks(labels_of(chosen, test.selection), totals), test.hint);
    if (test.hint == 0 && highest_hint() > 0) std::cout << "A hint on what is wrong: the same with --hint 1\n";
  }
  return totals;
}
#endif

}  // namespace

void add_test(CLI::App& app) {
  CLI::App* command = app.add_subcommand("test", "Run the tests of a stage, of a task or all");
  const auto test = std::make_shared<Test>();
  command->add_option("STAGE|TASK", test->selection, "A stage (5, reflections) or a task (5.1); default: all tests");
  add_with_options(*command, test->submissions);
  add_hint_option(*command, test->hint);
  command->footer(
      "With --with the tests judge that code: the unit tests of its tasks, and the images of its stages. Its other stages\n"
      "are the solution's. RAYLAB_HINTS=0 to 3 in the environment says how much --hint may tell.\n\n"
      "Exit code: 0 all passed, 1 some failed, 2 there is no such stage or task.\n\n"
      "Examples:\n  raylab test\n  raylab test 5\n  raylab test 5.1\n  raylab test 5.1 --with my-lab\n"
      "  raylab test --with my-lab --sanitize\n  raylab test 2 --with my-lab --hint 1");
  command->callback([test] {
#ifdef RAYLAB_WITH_TESTS
    const test::Totals totals = run(*test);
    if (totals.passed + totals.failed == 0)
      throw Failure("there are no such tests" + std::string(test->submissions.with.empty() ? "" : " of what --with names"),
                    wrong_usage);
    std::cout << totals.passed << " passed, " << totals.failed << " failed\n";
    if (totals.failed > 0) throw Failure(std::to_string(totals.failed) + " tests failed");
#else
    throw Failure("the tests were left out when this raylab was built", wrong_usage);
#endif
  });
}

}  // namespace raylab::cli
