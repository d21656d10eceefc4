#define CATCH_CONFIG_RUNNER
#include "tests/runner.hpp"

#include "core/render/stages_engine.hpp"
#include "tests/catch.hpp"

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace raylab::test {

namespace fs = std::filesystem;

namespace {

StageTable table_under_test;
MakeEngine make_under_test;
Totals totals;

#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
#else
using ListenerBase = Catch::TestEventListenerBase;
#endif

/// Hears how the tests end, which Catch2 otherwise only prints.
struct TotalsListener : ListenerBase {
  using ListenerBase::ListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo& test) override {
    ListenerBase::testCaseStarting(test);
    running = test.name;
  }
  void testCaseEnded(const Catch::TestCaseStats& test) override {
    if (test.totals.testCases.failed > 0) totals.failures.push_back(running);
    ListenerBase::testCaseEnded(test);
  }
  void testRunEnded(const Catch::TestRunStats& run) override {
    totals.passed = static_cast<std::size_t>(run.totals.testCases.passed);
    totals.failed = static_cast<std::size_t>(run.totals.testCases.failed);
  }

  std::string running;
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
  make_under_test = [](const Scene& scene, const Settings& settings) {
    return make_stages(scene, settings, table_under_test);
  };
  return run(selection, report);
}

Totals run_tests(const std::string& selection, const StageTable& table, const MakeEngine& make) {
  table_under_test = table;
  make_under_test = make;
  return run(selection, {});
}

const StageTable& table() { return table_under_test; }

std::unique_ptr<Engine> engine_under_test(const Scene& scene, const Settings& settings) {
  return make_under_test(scene, settings);
}

}  // namespace raylab::test
