#pragma once

#include "core/grade/grading.hpp"
#include "core/submission/sandbox.hpp"
#include "core/submission/taken_files.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace raylab::cli {

/// What decides how submissions are graded, the same for a class and for one of it.
struct GradingOptions {
  std::string out;
  std::string config;  ///< empty for the usual one
  std::string seed;
  bool unsafe = false;
};

/// Adds --out, --config, --seed and --unsafe.
void add_grading_options(CLI::App& command, GradingOptions& options);

/// The usual grading.toml, changed as `config` says. Throws Failure after printing its mistakes.
Grading grading_of(const std::string& config);

/// A hash of all that decides a submission's result.
std::string inputs_of(const TakenFiles& files, const GradingOptions& options);

/// Throws Failure if this machine cannot keep strangers' code from itself, unless the user wants it all the same.
void require_safe(const Sandbox& sandbox, bool unsafe);

}  // namespace raylab::cli
