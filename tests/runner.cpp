#define CATCH_CONFIG_RUNNER
#include "tests/runner.hpp"

#include "core/render/stages_engine.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace raylab::test {

namespace fs = std::filesystem;

namespace {

StageTable table_under_test;
bool submission_under_test = false;
MakeEngine make_under_test;
Totals totals;
bool told = false;  ///< is each test told of, as it ends?

#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
using AssertionEnded = void;
#else
using ListenerBase = Catch::TestEventListenerBase;
using AssertionEnded = bool;
#endif

constexpr std::string_view unknown = "{Unknown expression after the reported line}";  // Catch2's, of what throws elsewhere

const std::string indent(failure_indent, ' ');

/// A failed assertion in a few lines.
std::string in_words(const Catch::AssertionStats& stats) {
  const Catch::AssertionResult& result = stats.assertionResult;
  std::string text;
  const auto add = [&](std::string line) {
    std::replace(line.begin(), line.end(), '\n', ' ');
    text += indent + line + '\n';
  };
  const std::string message(result.getMessage());
  if (result.hasExpression() && result.getExpression() != unknown) add(result.getExpressionInMacro());
  if (result.hasExpandedExpression() && result.getExpandedExpression() != result.getExpression())
    add("is " + result.getExpandedExpression());
  if (result.hasMessage()) text += indent + message + '\n';
  for (const Catch::MessageInfo& info : stats.infoMessages)
    if (info.message != message) text += indent + info.message + '\n';
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
  }
  AssertionEnded assertionEnded(const Catch::AssertionStats& stats) override {
    if (!stats.assertionResult.isOk()) {
      if (first_failure.empty())
        first_failure = in_words(stats);
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
      std::cout << (test.totals.testCases.failed > 0 ? "FAILED  " : "passed  ") << running << '\n' << first_failure;
      if (more_failures > 0) std::cout << "        and " << more_failures << " more\n";
      std::cout << std::flush;
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
  told = false;
  return run(selection, report);
}

Totals run_tests(const std::string& selection, const StageTable& table, const MakeEngine& make,
                 const std::filesystem::path& report) {
  table_under_test = table;
  submission_under_test = true;
  make_under_test = make;
  told = report.empty();
  return run(selection, told ? "/dev/null" : report);
}

const StageTable& table() { return table_under_test; }

bool judging_submission() { return submission_under_test; }

std::unique_ptr<Engine> engine_under_test(const Scene& scene, const Settings& settings) {
  return make_under_test(scene, settings);
}

}  // namespace raylab::test
