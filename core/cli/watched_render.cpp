#include "core/cli/watched_render.hpp"

#include "core/image/terminal.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <thread>

namespace raylab::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> interrupt_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void on_interrupt(int signal) {
  interrupt_asked = true;
  std::signal(signal, SIG_DFL);
}

/// One line on the terminal, drawn over and over; nothing where standard error is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what) : what_(std::move(what)) {}
  ~ProgressBar() {
    if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double done) {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (!on_terminal_ || seconds < 1 || seconds < drawn_at_ + 0.1) return;
    drawn_ = true;
    drawn_at_ = seconds;
    const int columns = std::clamp(terminal_columns() - static_cast<int>(what_.size()) - 30, 10, 40);
    const int filled = static_cast<int>(done * columns);
    std::cerr << "\r" << what_ << "  [" << std::string(static_cast<std::size_t>(filled), '#')
              << std::string(static_cast<std::size_t>(columns - filled), '.') << "]" << percent(done)
              << (done > 0 ? remaining(seconds * (1 - done) / done) : "") << "\x1b[K" << std::flush;
  }

 private:
  static std::string percent(double done) {
    char text[16];
    std::snprintf(text, sizeof text, " %3d %%", static_cast<int>(100 * done));
    return text;
  }

  static std::string remaining(double seconds) {
    const long long whole = static_cast<long long>(seconds + 0.5);
    char text[48];
    if (whole >= 3600)
      std::snprintf(text, sizeof text, "  %lld:%02lld h left", whole / 3600, whole / 60 % 60);
    else
      std::snprintf(text, sizeof text, "  %lld:%02lld min left", whole / 60, whole % 60);
    return text;
  }

  const std::string what_;
  const bool on_terminal_ = error_is_terminal();
  const Clock::time_point start_ = Clock::now();
  bool drawn_ = false;
  double drawn_at_ = 0;
};

}  // namespace

const std::atomic<bool>& interrupt_flag() {
  static const bool installed = [] {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
#ifdef SIGHUP  // the terminal was closed
    std::signal(SIGHUP, on_interrupt);
#endif
    return true;
  }();
  (void)installed;
  return interrupt_asked;
}

unsigned thread_count(unsigned wanted) { return wanted != 0 ? wanted : std::max(1u, std::thread::hardware_concurrency()); }

RenderTotals watched_render(const Engine& engine, ImageSize size, unsigned threads, const std::string& what,
                            const RowSink& sink, const std::function<void()>& tick) {
  RenderTotals totals;
  {
    ProgressBar bar(what);
    const auto report = [&](double done) {
      bar.show(done);
      tick();
    };
    totals = render(engine, size, thread_count(threads), sink, report, interrupt_flag());
  }
  if (totals.non_finite_pixels > 0)
    std::cerr
        << "raylab: warning: " << totals.non_finite_pixels
        << " pixels are not finite numbers (they are black in 8 bits): a task or a formula divides by zero somewhere\n";
  return totals;
}

}  // namespace raylab::cli
