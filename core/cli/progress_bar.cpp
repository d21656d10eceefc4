#include "core/cli/progress_bar.hpp"

#include "core/image/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <utility>

namespace raylab::cli {
namespace {

std::string percent(double done) {
  char text[16];
  std::snprintf(text, sizeof text, " %3d %%", static_cast<int>(100 * done));
  return text;
}

std::string remaining(double seconds) {
  const long long whole = static_cast<long long>(seconds + 0.5);
  char text[48];
  if (whole >= 3600)
    std::snprintf(text, sizeof text, "  %lld:%02lld h left", whole / 3600, whole / 60 % 60);
  else
    std::snprintf(text, sizeof text, "  %lld:%02lld min left", whole / 60, whole % 60);
  return text;
}

}  // namespace

ProgressBar::~ProgressBar() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void ProgressBar::show(double done) {
  if (!done_before_) done_before_ = done;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (!error_is_terminal() || seconds < 1 || seconds < drawn_at_ + 0.1) return;
  drawn_ = true;
  drawn_at_ = seconds;
  const int columns = std::clamp(terminal_columns() - static_cast<int>(what_.size()) - 30, 10, 40);
  const int filled = static_cast<int>(done * columns);
  const double since = done - *done_before_;
  std::cerr << "\r" << what_ << "  [" << std::string(static_cast<std::size_t>(filled), '#')
            << std::string(static_cast<std::size_t>(columns - filled), '.') << "]" << percent(done)
            << (since > 0 ? remaining(seconds * (1 - done) / since) : "") << "\x1b[K" << std::flush;
}

void ProgressBar::show(double done, std::string what) {
  what_ = std::move(what);
  show(done);
}

}  // namespace raylab::cli
