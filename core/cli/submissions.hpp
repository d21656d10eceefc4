#pragma once

#include "core/submission/stage_files.hpp"
#include "core/submission/worker.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace raylab::cli {

/// Whose code takes part: the options --with and --sanitize.
struct WithOptions {
  std::vector<std::string> with;  ///< "DIR", "DIR:1-4,5.1"; a later one wins
  bool sanitize = false;
};

/// Adds --with and --sanitize.
void add_with_options(CLI::App& command, WithOptions& options);

/// What --with names. Throws Failure.
std::vector<Chosen> chosen_submissions(const WithOptions& options);

/// Builds the stages first to last of what --with names. stand_in: does the solution answer for what is not written?
/// Warnings go to standard error. Throws Failure if something does not compile, after the compiler's messages.
WorkerSetup build_with(const WithOptions& options, int first_stage, int last_stage, bool stand_in = true);

/// Tells the user on standard error that a task is not written and the solution's stands in for it.
void tell_stand_in(const std::string& what);

}  // namespace raylab::cli
