#include "core/cli/command.hpp"
#include "core/grade/class_folder.hpp"
#include "core/grade/class_reports.hpp"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

struct Merge {
  std::vector<std::string> folders;
  std::string out;
};

void merge(const Merge& wanted) {
  const std::optional<std::string> seed = ClassFolder::seed_of(wanted.folders.front());
  if (!seed) throw Failure(wanted.folders.front() + ": was not written by 'raylab grade'", wrong_usage);
  const ClassFolder out(wanted.out, *seed);
  out.write_run(ClassFolder(wanted.folders.front(), *seed).run());
  for (const std::string& folder : wanted.folders) {
    const std::optional<std::string> own = ClassFolder::seed_of(folder);
    if (!own) throw Failure(folder + ": was not written by 'raylab grade'", wrong_usage);
    out.take_over(ClassFolder(folder, *own));
  }
  const ClassResults results = write_reports(out);
  std::cout << results.submissions.size() << " submissions: " << (std::filesystem::path(wanted.out) / "index.html").string()
            << '\n';
}

}  // namespace

void add_merge(CLI::App& app) {
  CLI::App* command = app.add_subcommand("merge", "Make one class of what 'raylab grade --shard' has graded in parts");
  const auto wanted = std::make_shared<Merge>();
  command->add_option("OUT", wanted->folders, "Folders that were graded with the same seed")->required();
  command->add_option("--out", wanted->out, "The folder for all of it")->required()->type_name("DIR");
  command->footer("Example:\n  raylab merge part-1 part-2 part-3 part-4 --out graded");
  command->callback([wanted] { merge(*wanted); });
}

}  // namespace raylab::cli
