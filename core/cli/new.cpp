#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/submission/workspace.hpp"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

struct New {
  std::string folder;
  std::string solutions;
};

/// "1-3" or "2"; nothing for none.
std::vector<int> stages_in(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t dash = text.find('-');
  const int first = find_stage(text.substr(0, dash)).number;
  const int last = dash == std::string::npos ? first : find_stage(text.substr(dash + 1)).number;
  if (last < first) throw Failure("--solutions: wanted something like 1-3, got '" + text + "'", wrong_usage);
  std::vector<int> stages;
  for (int stage = first; stage <= last; ++stage) stages.push_back(stage);
  return stages;
}

void run(const New& wanted) {
  make_workspace(wanted.folder, stages_in(wanted.solutions));
  std::cout << wanted.folder << ": seven files to fill in, a handbook, scenes and reference renders.\n\n"
            << "  cd " << wanted.folder << "\n"
            << "  raylab render scenes/scene1.toml --stage 1 --with . --show\n"
            << "  raylab test 1.1 --with .\n\n"
            << "Begin with handbook/stages/README.md.\n";
}

}  // namespace

void add_new(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("new", "Make a folder to work in: the files to fill in, handbook, scenes, references");
  const auto wanted = std::make_shared<New>();
  command->add_option("DIR", wanted->folder, "A folder that does not exist yet, or is empty")->required();
  command
      ->add_option("--solutions", wanted->solutions,
                   "Add the solution of these stages, whose deadline has passed: 2, or 1-3; into DIR/solutions")
      ->type_name("STAGES");
  command->footer(
      "What is in it is a submission as it stands: 'raylab test --with DIR' judges it.\n\n"
      "Examples:\n"
      "  raylab new my-lab\n"
      "  raylab new my-lab --solutions 1-3");
  command->callback([wanted] { run(*wanted); });
}

}  // namespace raylab::cli
