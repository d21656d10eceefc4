#define CATCH_CONFIG_RUNNER
#include "tests/runner.hpp"

#include "tests/catch.hpp"

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace raylab::test {

namespace fs = std::filesystem;

namespace {

StageTable table_under_test;
fs::path called_as;
Totals totals;

#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
#else
using ListenerBase = Catch::TestEventListenerBase;
#endif

/// Hears the end of a run, whose totals Catch2 otherwise only prints.
struct TotalsListener : ListenerBase {
  using ListenerBase::ListenerBase;
  void testRunEnded(const Catch::TestRunStats& run) override {
    totals.passed = static_cast<std::size_t>(run.totals.testCases.passed);
    totals.failed = static_cast<std::size_t>(run.totals.testCases.failed);
  }
};
CATCH_REGISTER_LISTENER(TotalsListener)

/// Where the running program lies: the folder that it was called by, or the first one in PATH that has it.
fs::path folder_of_program() {
  if (called_as.has_parent_path()) return fs::weakly_canonical(called_as).parent_path();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (fs::exists(fs::path(folder) / called_as)) return fs::weakly_canonical(fs::path(folder) / called_as).parent_path();
  return {};
}

}  // namespace

Totals run_tests(const std::string& selection, const StageTable& table, const std::filesystem::path& program,
                 const std::filesystem::path& report) {
  static Catch::Session session;
  table_under_test = table;
  called_as = program;
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

const StageTable& table() { return table_under_test; }

std::filesystem::path data_folder(const std::string& name) {
  const fs::path installed = folder_of_program() / RAYLAB_DATA_FROM_PROGRAM / name;
  return fs::exists(installed) ? installed : fs::path(RAYLAB_SOURCE_FOLDER) / name;
}

}  // namespace raylab::test
