#include "core/cli/hints.hpp"

#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#ifdef RAYLAB_WITH_TESTS
#include "tests/hints/hints.hpp"
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace raylab::cli {

void add_hint_option(CLI::App& command, int& level) {
  command
      .add_option(
          "--hint", level,
          "Hints on what is wrong: 1 what is observed, 2 where to look too, 3 what the mistake is called, if it is a "
          "known one")
      ->check(CLI::Range(1, 3))
      ->type_name("1|2|3");
}

int highest_hint() {
  const char* const course = std::getenv("RAYLAB_HINTS");
  if (!course) return 3;
  const std::string text = course;
  if (text.size() != 1 || text[0] < '0' || text[0] > '3')
    throw Failure("RAYLAB_HINTS in the environment: wanted 0, 1, 2 or 3, got '" + text + "'", wrong_usage);
  return text[0] - '0';
}

void print_hints([[maybe_unused]] const AskTask& ask, [[maybe_unused]] const std::vector<std::string_view>& labels,
                 int level) {
  if (level == 0) return;
  const int allowed = std::min(level, highest_hint());
  if (allowed < level)
    std::cerr << "raylab: this course gives " << (allowed == 0 ? "no hints" : "hints up to level " + std::to_string(allowed))
              << " (RAYLAB_HINTS)\n";
  if (allowed == 0) return;
#ifdef RAYLAB_WITH_TESTS
  const std::vector<test::Hint> hints = test::find_hints(solution_table(), ask, test::find_probes(solution_table(), labels));
  std::cout << '\n'
            << (hints.empty() ? "No hint: every task answers as the solution does.\n" : test::hints_text(hints, allowed));
#else
  throw Failure("the tests, which hints are made of, were left out when this raylab was built", wrong_usage);
#endif
}

}  // namespace raylab::cli
