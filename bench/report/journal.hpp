#pragma once

#include "bench/report/unit.hpp"

#include <filesystem>
#include <fstream>
#include <string>

namespace raylab::bench {

/// What a run has measured so far, on disk: a line for each finished unit, so that an interrupted run loses none.
class Journal {
 public:
  /// Opens the journal of the run that `identity` describes, or begins it, and its folder. A last line that was cut off is
  /// dropped. Throws std::runtime_error if it cannot be read or written, or is another run's.
  Journal(std::filesystem::path path, const Json& identity);

  /// What was found, and has been added since: by unit.
  const Results& results() const { return results_; }

  /// How long the finished units took, in seconds, and when the run began (UTC, "2026-11-22T21:30:00Z").
  double seconds() const { return seconds_; }
  const std::string& date() const { return date_; }

  /// Keeps a unit's result, on disk first. Throws std::runtime_error.
  void add(const std::string& unit, Json result, double seconds);

  /// Removes the file: the run is over.
  void remove();

 private:
  /// Is there anything in the file?
  bool read(const Json& identity);
  void append(const Json& line);

  std::filesystem::path path_;
  std::ofstream out_;
  Results results_;
  double seconds_ = 0;
  std::string date_;
};

}  // namespace raylab::bench
