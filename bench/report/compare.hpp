#pragma once

#include "bench/report/figures.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace raylab::bench {

/// What is no report of raylab bench.
struct NoReport : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A figure that differs between two reports by more than noise.
struct Change {
  Figure before, after;
  double ratio = 1;  ///< after by before; infinite where that was 0
  bool better = false;
};

/// How two reports differ.
struct ReportChanges {
  std::vector<std::string> runs_differ;  ///< how the runs do: machine, compiler, mode, scenes; some words each
  bool too_noisy = false;                ///< was the machine too busy, in one of them, to compare times at all?
  double timing_ratio = 1;               ///< the median over all times that both have: how much slower the second run was
  std::size_t times = 0, errors = 0;     ///< figures that both have
  std::vector<Change> changed_times, changed_errors;  ///< the greatest changes first
  std::vector<std::string> only_before, only_after;   ///< what has figures in one of them only
};

/// A time has changed where its medians are further apart than three times what the quartiles of both allow, and than 5 %;
/// none has if in one of the runs more than a tenth of the times are noisy: then the machine has changed, now and then.
/// Errors are the same on each run of the same program: they have changed where they differ by more than 1 in 1e6.
/// Throws NoReport if one of them is none, and nlohmann's exceptions if it lacks what a report has.
ReportChanges compare_reports(const Json& before, const Json& after);

}  // namespace raylab::bench
