#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace raylab::cli {

/// One line on the terminal, drawn over and over, once the work takes longer than a second; nothing where standard error is
/// no terminal. It is wiped away at the end.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what) : what_(std::move(what)) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws it, at most ten times a second. done: 0 to 1; the first one that is told is what was there already, and does not
  /// count for the remaining time.
  void show(double done);

  /// The same, and names what is being done from now on.
  void show(double done, std::string what);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  const Clock::time_point start_ = Clock::now();
  std::optional<double> done_before_;
  bool drawn_ = false;
  double drawn_at_ = 0;
};

}  // namespace raylab::cli
