#pragma once

#include <CLI/CLI.hpp>

#include <stdexcept>

namespace raylab::cli {

/// Exit codes of the program.
enum ExitCode { success = 0, failure = 1, wrong_usage = 2, interrupted = 130 };

/// Ends a command with an exit code; what() is for the user.
struct Failure : std::runtime_error {
  explicit Failure(const std::string& what, ExitCode exit_code = failure) : std::runtime_error(what), code(exit_code) {}
  ExitCode code;
};

// Each adds its command, with its options and help, to the program. A command that is given runs while the command line is
// parsed, and throws Failure or any other exception if it fails.

void add_new(CLI::App& app);
void add_render(CLI::App& app);
void add_sheet(CLI::App& app);
void add_check_scene(CLI::App& app);
void add_stages(CLI::App& app);
void add_call(CLI::App& app);
void add_test(CLI::App& app);
void add_diff(CLI::App& app);
void add_explain(CLI::App& app);
void add_bench(CLI::App& app);  ///< in builds with engine and oracle
void add_handout(CLI::App& app);
// In builds with engine, oracle and tests:
void add_grade(CLI::App& app);
void add_grade_one(CLI::App& app);
void add_merge(CLI::App& app);

void add_reference(CLI::App& app);
void add_doctor(CLI::App& app);

}  // namespace raylab::cli
