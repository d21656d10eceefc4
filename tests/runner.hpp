#pragma once

#include "core/render/engine.hpp"
#include "core/render/stage_table.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace raylab::test {

/// Blanks before each line of a failure's text, which is printed below a test's name.
inline constexpr std::size_t failure_indent = 8;

/// How many test cases passed and failed.
struct Totals {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::vector<std::string> failures = {};  ///< the names of those that failed, in their order
  std::vector<std::string> texts = {};     ///< of each of them its first failure, in some lines: of tell_tests() alone
};

/// Runs the tests that a Catch2 selection like "[stage5]" or "[5.1]" names, all for an empty one, on `table`. The report
/// goes to `report`, or to standard output if that is empty.
Totals run_tests(const std::string& selection, const StageTable& table, const std::filesystem::path& report = {});

/// The same for a submission: as strict as a right answer in float arithmetic and the accepted variants (docs/errata.md)
/// allow. `make` makes the images: a table whose functions run in another process would take an hour over them.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Scene&, const Settings&)>;
Totals run_tests(const std::string& selection, const StageTable& table, const MakeEngine& make,
                 const std::filesystem::path& report);

/// The same, for the one who has submitted it: `out` gets a line a test and, of a failed one, its first failure, with the
/// call that it is about and how to repeat that. `with` says whose tasks these are: "--with my-lab".
Totals tell_tests(const std::string& selection, const StageTable& table, const MakeEngine& make, const std::string& with,
                  std::ostream& out);

/// The table that the running tests judge.
const StageTable& table();

/// Is it a submission's? If not, it is one of raylab's own, and answers for every digit of a double.
bool judging_submission();

/// An engine that makes images with it. `scene` must outlive it.
std::unique_ptr<Engine> engine_under_test(const Scene& scene, const Settings& settings);

}  // namespace raylab::test
