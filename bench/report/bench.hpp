#pragma once

#include "bench/report/images.hpp"
#include "bench/report/unit.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace raylab::bench {

/// What `raylab bench` is to do.
struct BenchRun {
  Plan plan;
  std::vector<BenchScene> scenes;
  std::vector<std::string> scene_hashes;  ///< SHA-1 of the scenes' files, in order
  std::filesystem::path out;              ///< the folder
  std::string command;                    ///< that repeats this run, for the report's header
};

/// Told before each piece of work: which part is done, from 0 to 1, and what comes now.
using BenchProgress = std::function<void(double done, const std::string& unit)>;

/// Measures, and writes report.json, report.csv and report.html into the folder, each whole or not at all. What is measured
/// is kept in measurements.jsonl there until the report is written: the same run, interrupted, goes on where it was.
/// Returns the report; docs/bench.md has its format. Throws Cancelled soon after `cancel` is set, and std::runtime_error if
/// files cannot be written or the folder holds the interrupted run of something else.
Json run_bench(const BenchRun& run, const StageTable& stages, const BenchProgress& progress,
               const std::atomic<bool>& cancel);

}  // namespace raylab::bench
