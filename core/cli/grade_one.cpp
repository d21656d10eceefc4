#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/grade_views.hpp"
#include "core/cli/grading_options.hpp"
#include "core/grade/class_folder.hpp"
#include "core/grade/grade_submission.hpp"
#include "tests/hints/hints.hpp"
#include "tests/runner.hpp"
#include "tests/selection.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raylab::cli {
namespace {

struct One {
  GradingOptions options;
  std::string folder;
  std::string id;
};

/// Lines as they are printed below a test's name, without the blanks before all of them.
std::string without_indent(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) all += line.substr(std::min(line.size(), test::failure_indent)) + '\n';
  return all;
}

TestOutcome run_unit_tests(std::string_view task, const StageTable& table) {
  std::ostringstream nowhere;
  const auto no_images = [](const Scene&, const Settings&) -> std::unique_ptr<Engine> {
    throw std::logic_error("a task's tests need no image");
  };
  const test::Totals totals = test::tell_tests(test::tests_of_submission(task), table, no_images, with_submission, nowhere);
  TestOutcome outcome{static_cast<int>(totals.passed), {}};
  for (std::size_t k = 0; k < totals.failures.size(); ++k)
    outcome.failed.push_back({totals.failures[k], without_indent(totals.texts[k])});
  return outcome;
}

WrongTask look_at(std::string_view task, const AskTask& ask, int level) {
  const std::vector<test::Hint> hints = test::find_hints(solution_table(), ask, test::find_probes(solution_table(), {task}));
  if (hints.empty()) return {};
  return {level > 0 ? test::hints_text(hints, level) : "", hints.front().mistake};
}

void grade_one(const One& wanted) {
  adopt_orphans();
  const ClassFolder out(wanted.options.out, wanted.options.seed);
  const Grading grading = grading_of(wanted.options.config);
  const TakenFiles files = take_files(wanted.folder);
  const Sandbox sandbox;
  require_safe(sandbox, wanted.options.unsafe);
  const GradingTools tools{sandbox, solution_table(), run_unit_tests, look_at};
  const std::vector<View> views = grading_views(grading, wanted.options.seed, out.path() / "views");
  SubmissionResult result = grade_submission(files, grading, views, tools, out.submission(wanted.id));
  result.id = wanted.id;
  result.inputs = inputs_of(files, wanted.options);
  end_children();
  out.finish(result, processor_seconds());
}

}  // namespace

void add_grade_one(CLI::App& app) {
  CLI::App* command = app.add_subcommand("grade-one", "What 'raylab grade' runs for each submission")->group("");
  const auto wanted = std::make_shared<One>();
  command->add_option("DIR", wanted->folder)->required();
  command->add_option("--id", wanted->id)->required();
  add_grading_options(*command, wanted->options);
  command->callback([wanted] { grade_one(*wanted); });
}

}  // namespace raylab::cli
