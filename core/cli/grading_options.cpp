#include "core/cli/grading_options.hpp"

#include "core/calls/call_task.hpp"
#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"

#include <exception>
#include <filesystem>
#include <iostream>
#include <utility>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

Grading checked(GradingFile file) {
  for (const Diagnostic& diagnostic : file.diagnostics) std::cerr << to_string(diagnostic) << '\n';
  if (!file.grading) throw Failure("the grading file has mistakes: they stand above", wrong_usage);
  return std::move(*file.grading);
}

fs::path usual_config() { return data_folder("course/grading.toml"); }

/// Has the solution an answer to each hidden test?
void require_answers(const Grading& grading) {
  for (std::size_t k = 0; k < grading.hidden.size(); ++k) try {
      const HiddenTest& test = grading.hidden[k];
      TaskCaller(solution_table(), task_info(test.task)).result(test.call);
    } catch (const std::exception& error) {
      throw Failure("the grading file's hidden_test[" + std::to_string(k) + "].call: " + error.what(), wrong_usage);
    }
}

}  // namespace

void add_grading_options(CLI::App& command, GradingOptions& options) {
  command.add_option("--out", options.out, "The folder for results and reports")->required()->type_name("OUT");
  command.add_option("--config", options.config, "A grading.toml, in place of the usual one")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  command.add_option("--seed", options.seed, "Decides the hidden cameras and the ids; default: a new one")
      ->type_name("TEXT");
  command.add_flag("--unsafe", options.unsafe, "Grade even where this machine cannot keep strangers' code from itself");
}

Grading grading_of(const std::string& config) {
  Grading grading = checked(read_grading(usual_config(), {}));
  if (!config.empty()) grading = checked(read_grading(config, grading));
  require_answers(grading);
  return grading;
}

std::string inputs_of(const TakenFiles& files, const GradingOptions& options) {
  std::string all = std::string(RAYLAB_VERSION) + '\n' + options.seed + '\n' + file_hash(usual_config()) + '\n';
  if (!options.config.empty()) all += file_hash(options.config) + '\n';
  for (const auto& [stage, text] : files.texts)
    all += std::to_string(stage) + ' ' + std::to_string(text.size()) + '\n' + text;
  for (const auto& [stage, why] : files.refused) all += std::to_string(stage) + ' ' + why + '\n';
  for (const std::string& note : files.notes) all += note + '\n';
  return text_hash(all);
}

void require_safe(const Sandbox& sandbox, bool unsafe) {
  if (sandbox.is_safe() || unsafe) return;
  std::string text = "this machine cannot keep strangers' code from itself:\n";
  for (const Protection& protection : sandbox.protections())
    if (!protection.holds) text += "  not " + protection.name + ": " + protection.by + '\n';
  throw Failure(text +
                "Install bubblewrap, or see 'raylab doctor'; --unsafe grades all the same, and says so in the report");
}

}  // namespace raylab::cli
