#include "core/cli/command.hpp"
#include "core/submission/workspace.hpp"

#include <iostream>
#include <memory>
#include <string>

namespace raylab::cli {
namespace {

struct Handout {
  std::string folder;
  std::string package;
};

}  // namespace

void add_handout(CLI::App& app) {
  CLI::App* command = app.add_subcommand("handout", "Write what a course publishes: no solution, no hidden test");
  const auto wanted = std::make_shared<Handout>();
  command->add_option("DIR", wanted->folder, "A folder that does not exist yet, or is empty")->required();
  command->add_option("--package", wanted->package, "raylab's Debian package, to be handed out with it")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  command->footer(
      "It holds what 'raylab new' makes, for students who install raylab from its package: docs/grading.md.\n\n"
      "Examples:\n"
      "  raylab handout lab\n"
      "  raylab handout lab --package raylab_0.1.0_amd64.deb");
  command->callback([wanted] {
    make_handout(wanted->folder, wanted->package);
    std::cout << wanted->folder
              << ": seven files to fill in, a handbook, scenes and reference renders; publish it as it is\n";
  });
}

}  // namespace raylab::cli
