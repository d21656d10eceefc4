#include "core/cli/submissions.hpp"

#include "core/cli/command.hpp"
#include "core/image/terminal.hpp"
#include "core/submission/submission.hpp"

#include <algorithm>
#include <cctype>
#include <exception>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string_view>

namespace raylab::cli {

namespace {

/// Tells the user on standard error, the first time.
void tell_once(const std::string& text) {
  static std::set<std::string> told;
  if (told.insert(text).second) std::cerr << (error_is_terminal() ? "\r\x1b[K" : "") << text << '\n';
}

/// As a shell needs it.
std::string shell_quoted(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) || c >= 0x80 || std::string_view("_./:,+-").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + '\'';
}

}  // namespace

void add_with_options(CLI::App& command, WithOptions& options) {
  CLI::Option* with = command
                          .add_option("--with", options.with,
                                      "A submission's folder, or DIR:4,5.1 for some of its stages and tasks, over the "
                                      "solution; a later --with wins")
                          ->type_name("DIR")
                          ->allow_extra_args(false)
                          ->take_all();
  command.add_flag("--sanitize", options.sanitize, "Run that code with checks of addresses and of undefined behaviour")
      ->needs(with);
}

std::vector<Chosen> chosen_submissions(const WithOptions& options) {
  std::vector<Chosen> all;
  try {
    for (const std::string& text : options.with) {
      all.push_back(parse_chosen(text));
      for (const std::string& warning : misnamed_files(all.back())) tell_once("raylab: warning: " + warning);
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
    for (const std::string& text : options.with)
      setup.with += (setup.with.empty() ? "--with " : " --with ") + shell_quoted(text);
    if (options.sanitize) setup.with += " --sanitize";
    return setup;
  } catch (const DoesNotCompile& error) {
    std::cerr << error.what();
    throw Failure("this does not compile: the reason stands above, with file and line");
  }
}

void tell_stand_in(const std::string& what) { tell_once("raylab: " + what + ": the solution's stands in for it"); }

}  // namespace raylab::cli
