#define CATCH_CONFIG_RUNNER
#include "tests/runner.hpp"

#include "core/explain/explanation.hpp"
#include "core/explain/recording.hpp"
#include "core/render/stages_engine.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

namespace raylab::test {

namespace fs = std::filesystem;

namespace {

StageTable table_under_test;
bool submission_under_test = false;
MakeEngine make_under_test;
Totals totals;
std::optional<std::string> told;   ///< whose tasks these are, if each test is told of as it ends
std::ostream* listener = nullptr;  ///< where to

#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
using AssertionEnded = void;
#else
using ListenerBase = Catch::TestEventListenerBase;
using AssertionEnded = bool;
#endif

const std::string indent(failure_indent, ' ');

/// Lines below a label, which the first one stands beside.
std::string labeled(const std::string& label, const std::vector<std::string>& lines) {
  constexpr std::size_t width = 10;
  std::string text, before = label + std::string(width - std::min(width, label.size()), ' ');
  for (const std::string& line : lines) {
    text += indent + before + line + '\n';
    before = std::string(width, ' ');
  }
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

/// Both sides of what was compared: "0.5" and "1, give or take 1e-6", or "< 1".
struct Sides {
  std::string got, expected;
};

/// Of "left == right", which Catch2 breaks around the operator if it is long; of something alone, which should hold, that.
Sides sides_of(std::string expression) {
  std::replace(expression.begin(), expression.end(), '\n', ' ');
  for (const std::string comparison : {" == ", " >= ", " <= ", " < ", " > ", " != "})
    if (const std::size_t place = expression.find(comparison); place != std::string::npos)
      return {expression.substr(0, place),
              (comparison == " == " ? "" : comparison.substr(1)) + expression.substr(place + comparison.size())};
  if (expression.starts_with("!(")) return {expression.substr(2, expression.size() - 3), "false"};
  if (expression.starts_with('!')) return {expression.substr(1), "false"};
  return {expression, "true"};
}

/// Was the answer of a task compared, and not something that was made of it?
bool is_answer(const Catch::AssertionResult& result) {
  const std::string left = sides_of(result.getExpression()).got;
  return left.starts_with("table().") && left.ends_with(')');
}

std::string comparison_in_words(const Catch::AssertionResult& result) {
  const Sides sides = sides_of(result.getExpandedExpression());
  return (is_answer(result) ? "" : labeled("checked", {sides_of(result.getExpression()).got})) +
         labeled("expected", {sides.expected}) + labeled("got", {sides.got});
}

/// The last call of the task that the test is about.
std::optional<RecordedCall> last_call(std::string_view test) {
  const std::vector<Event> events = stop_recording();
  const auto last = std::find_if(events.rbegin(), events.rend(), [&](const Event& event) {
    const auto* const call = std::get_if<RecordedCall>(&event);
    return call && test.starts_with(call->task->label);
  });
  return last == events.rend() ? std::nullopt : std::optional(std::get<RecordedCall>(*last));
}

/// A failed assertion in a few lines: what was asked, expected and answered, or what Catch2 has to say.
std::string in_words(const Catch::AssertionStats& stats, std::string_view test) {
  const Catch::AssertionResult& result = stats.assertionResult;
  std::string text, said(result.getMessage());
  for (const Catch::MessageInfo& info : stats.infoMessages)
    if (info.message != said) said += '\n' + info.message;
  const std::optional<RecordedCall> call = last_call(test);
  if (call) text += labeled("asked", value_lines(call->arguments));
  if (call && !call->result.empty() && !(said.empty() && is_answer(result)))
    text += labeled("answered", value_lines(call->result));
  if (said.empty()) text += comparison_in_words(result);
  for (const std::string& line : lines_of(said)) text += indent + line + '\n';
  if (call && said.find("raylab call") == std::string::npos)
    text += labeled("again", {"raylab call " + std::string(call->task->label) + " '" + call->arguments + "' " + *told});
  return text;
}

/// Hears how the tests end, which Catch2 otherwise only prints; and tells of each, if asked to, with its first failure.
struct TotalsListener : ListenerBase {
  using ListenerBase::ListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo& test) override {
    ListenerBase::testCaseStarting(test);
    running = test.name;
    first_failure.clear();
    more_failures = 0;
    if (told) stop_recording();  // the calls of the test before
  }
  AssertionEnded assertionEnded(const Catch::AssertionStats& stats) override {
    if (told && !stats.assertionResult.isOk()) {
      if (first_failure.empty())
        first_failure = in_words(stats, running);
      else
        ++more_failures;
    }
    return ListenerBase::assertionEnded(stats);
  }
  void testCaseEnded(const Catch::TestCaseStats& test) override {
    if (test.totals.testCases.failed > 0) {
      totals.failures.push_back(running);
      totals.texts.push_back(first_failure);
    }
    if (told) {
      *listener << (test.totals.testCases.failed > 0 ? "FAILED  " : "passed  ") << running << '\n' << first_failure;
      if (more_failures > 0) *listener << indent << "and " << more_failures << " more\n";
      *listener << std::flush;
    }
    ListenerBase::testCaseEnded(test);
  }
  void testRunEnded(const Catch::TestRunStats& run) override {
    totals.passed = static_cast<std::size_t>(run.totals.testCases.passed);
    totals.failed = static_cast<std::size_t>(run.totals.testCases.failed);
    ListenerBase::testRunEnded(run);
  }

  std::string running;
  std::string first_failure;
  std::size_t more_failures = 0;
};
CATCH_REGISTER_LISTENER(TotalsListener)

Totals run(const std::string& selection, const std::filesystem::path& report) {
  static Catch::Session session;
  totals = {};
  std::vector<std::string> arguments{"raylab test"};
  if (!selection.empty()) arguments.push_back(selection);
  if (!report.empty()) arguments.insert(arguments.end(), {"--out", report.string()});
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  session.useConfigData({});
  if (session.applyCommandLine(static_cast<int>(argv.size()), argv.data()) != 0)
    throw std::runtime_error("Catch2 does not take the selection '" + selection + "'");
  session.run();
  return totals;
}

}  // namespace

Totals run_tests(const std::string& selection, const StageTable& table, const std::filesystem::path& report) {
  table_under_test = table;
  submission_under_test = false;
  make_under_test = [](const Scene& scene, const Settings& settings) {
    return make_stages(scene, settings, table_under_test);
  };
  told.reset();
  return run(selection, report);
}

Totals run_tests(const std::string& selection, const StageTable& table, const MakeEngine& make,
                 const std::filesystem::path& report) {
  table_under_test = table;
  submission_under_test = true;
  make_under_test = make;
  told.reset();
  return run(selection, report);
}

Totals tell_tests(const std::string& selection, const StageTable& table, const MakeEngine& make, const std::string& with,
                  std::ostream& out) {
  table_under_test = start_recording(table);
  submission_under_test = true;
  make_under_test = make;
  told = with;
  listener = &out;
  return run(selection, "/dev/null");
}

const StageTable& table() { return table_under_test; }

bool judging_submission() { return submission_under_test; }

std::unique_ptr<Engine> engine_under_test(const Scene& scene, const Settings& settings) {
  return make_under_test(scene, settings);
}

}  // namespace raylab::test
