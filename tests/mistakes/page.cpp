#include "tests/mistakes/page.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace raylab::test {
namespace {

const char* const introduction = R"(
What students get wrong, and what finds it. Each mistake of [`tests/mistakes/`](../tests/mistakes) is put into the solution by
itself, and then

* at least one unit test of its own task fails, and none of an earlier task: judged like the solution, with all tests to the
  last digits;
* the same, judged like a submission, which may compute in float and is not asked the `[hard]` ones. Then no test of a later
  task fails, either, though tasks that ask the mistaken one go wrong with it: [a mistake fails its own
  task](submissions.md#a-mistake-fails-its-own-task);
* an image that `raylab diff` judges is wrong, with a score of at least 2, where 1 is [the limit](tolerance.md): of a scene of
  its own stage or, where that stage cannot show it (a normal, say, in a picture of flat colors), of the next stage that can.

Listed are all tests of the task that fail, and the scene that shows the mistake best. The score is the lower one of floats and
8 bits, rounded down to one digit.

    build/release/bin/raylab-mistakes >docs/mistakes.md    # some minutes
    build/release/bin/raylab-mistakes docs/mistakes.md     # as ctest runs it: does the page hold, on the scenes that it names?
)";

const char* const what_contracts_rule_out = R"(
## Ruled out by the contracts

Some mistakes cannot be written, since the function is not told what it would take: a reflection tinted by `C` (5.2 knows no
color), the background beyond the last bounce (5.3 answers yes or no), Blinn-Phong on glass (the driver does not ask for it),
a light that a surface's own sphere blocks (the driver leaves it out).
)";

bool in_an_image(const Mistake& mistake) { return mistake.shows == Shows::in_images || mistake.shows == Shows::in_floats; }

/// Rounded down to one digit.
std::string text(double score) {
  if (std::isinf(score)) return "not finite";
  if (score < 1) return "below 1";
  const double unit = std::pow(10, std::floor(std::log10(score)));
  return std::to_string(static_cast<long>(std::floor(score / unit) * unit));
}

/// What a test's name says holds, without the task and the function: "5.1 reflect: twice is where we began".
std::string statement(const std::string& test) {
  const std::size_t colon = test.find(": ");
  return colon == std::string::npos ? test : test.substr(colon + 2);
}

std::string failures(const Totals& tests) {
  std::string all = std::to_string(tests.failed) + " of " + std::to_string(tests.passed + tests.failed);
  for (const std::string& test : tests.failures) all += "<br>" + statement(test);
  return all;
}

std::string row_with_image(const FoundMistake& found) {
  const Mistake& mistake = found.mistake;
  std::ostringstream row;
  row << "| " << mistake.task << " | " << mistake.name << " | " << failures(found.tests) << " | " << found.image.scene
      << " | " << text(counted(mistake, found.image.scores)) << " |\n";
  return row.str();
}

std::string row_without_image(const FoundMistake& found) {
  std::ostringstream row;
  row << "| " << found.mistake.task << " | " << found.mistake.name << " | ";
  if (found.mistake.shows == Shows::in_unit_tests) row << failures(found.tests) << " | ";
  row << found.mistake.why << " |\n";
  return row.str();
}

std::size_t count(std::span<const FoundMistake> found, Shows shows) {
  return static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [&](const FoundMistake& f) { return f.mistake.shows == shows; }));
}

/// The cells of a table's row; nothing for any other line.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  if (line.rfind("| ", 0) != 0) return all;
  for (std::size_t begin = 2, end; (end = line.find(" |", begin)) != std::string::npos; begin = end + 3)
    all.push_back(line.substr(begin, end - begin));
  return all;
}

constexpr std::size_t cells_with_image = 5;
constexpr std::size_t scene_cell = 3;

}  // namespace

std::string full_name(const Mistake& mistake) { return std::string(mistake.task) + " " + std::string(mistake.name); }

std::string mistakes_page(std::span<const FoundMistake> found) {
  const std::size_t in_tests_only = count(found, Shows::in_unit_tests);
  std::ostringstream page;
  page << "# Known mistakes\n"
       << introduction << "\nThere are " << found.size() - count(found, Shows::nowhere) << " of them, "
       << found.size() - count(found, Shows::nowhere) - in_tests_only << " that show in images and " << in_tests_only
       << " that only unit tests can find.\n";
  for (const StageInfo& stage : stage_list()) {
    std::string rows;
    for (const FoundMistake& f : found)
      if (in_an_image(f.mistake) && stage_of(f.mistake.task) == stage.number) rows += row_with_image(f);
    if (rows.empty()) continue;
    page << "\n## Stage " << stage.number << ", " << stage.name
         << "\n\n| task | mistake | tests that fail | scene | score |\n|---|---|---|---|---|\n"
         << rows;
  }
  page << "\nIn floats, but not in 8 bits:\n\n";
  for (const FoundMistake& f : found)
    if (f.mistake.shows == Shows::in_floats) page << "* " << full_name(f.mistake) << ": " << f.mistake.why << ".\n";
  page << "\n## Unit tests only\n\nNo image of a scene shows these.\n\n"
          "| task | mistake | tests that fail | why no image shows it |\n|---|---|---|---|\n";
  for (const FoundMistake& f : found)
    if (f.mistake.shows == Shows::in_unit_tests) page << row_without_image(f);
  page << "\n## Equivalent\n\nThese look like mistakes and are none: no test fails, and no image changes. They are not "
          "counted.\n\n| task | what is left out or other | proof |\n|---|---|---|\n";
  for (const FoundMistake& f : found)
    if (f.mistake.shows == Shows::nowhere) page << row_without_image(f);
  page << what_contracts_rule_out;
  return page.str();
}

std::map<std::string, std::string> scenes_in(const std::string& page) {
  std::map<std::string, std::string> scenes;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (const auto row = cells(line); row.size() == cells_with_image) scenes[row[0] + " " + row[1]] = row[scene_cell];
  return scenes;
}

std::string without_scores(const std::string& page) {
  std::string stable;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    const auto row = cells(line);
    stable += (row.size() == cells_with_image ? line.substr(0, line.size() - row.back().size() - 3) : line) + '\n';
  }
  return stable;
}

}  // namespace raylab::test
