#include "core/cli/submissions.hpp"

#include "core/cli/command.hpp"
#include "core/image/terminal.hpp"
#include "core/submission/submission.hpp"

#include <exception>
#include <iostream>
#include <stdexcept>

namespace raylab::cli {

void add_with_options(CLI::App& command, WithOptions& options) {
  CLI::Option* with = command
                          .add_option("--with", options.with,
                                      "A submission's folder, or DIR:4,5.1 for some of its stages and tasks, over the "
                                      "solution; a later --with wins")
                          ->type_name("DIR")
                          ->take_all();
  command.add_flag("--sanitize", options.sanitize, "Run that code with checks of addresses and of undefined behaviour")
      ->needs(with);
}

std::vector<Chosen> chosen_submissions(const WithOptions& options) {
  std::vector<Chosen> all;
  try {
    for (const std::string& text : options.with) {
      all.push_back(parse_chosen(text));
      stage_files(all.back().folder);
    }
  } catch (const std::exception& error) {
    throw Failure(error.what(), wrong_usage);
  }
  return all;
}

WorkerSetup build_with(const WithOptions& options, int first_stage, int last_stage, bool stand_in) {
  const auto warn = [](const std::string& text) { std::cerr << text; };
  try {
    WorkerSetup setup = build_submissions(chosen_submissions(options), first_stage, last_stage, stand_in,
                                          {options.sanitize, error_is_terminal()}, warn);
    for (const std::string& text : options.with) setup.with += (setup.with.empty() ? "--with " : " --with ") + text;
    if (options.sanitize) setup.with += " --sanitize";
    return setup;
  } catch (const DoesNotCompile& error) {
    std::cerr << error.what();
    throw Failure("this does not compile: the reason stands above, with file and line");
  }
}

void tell_stand_in(const std::string& what) {
  std::cerr << (error_is_terminal() ? "\r\x1b[K" : "") << "raylab: " << what << ": the solution's stands in for it\n";
}

}  // namespace raylab::cli
