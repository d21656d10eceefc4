#include "core/cli/watched_render.hpp"

#include "core/cli/progress_bar.hpp"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <thread>

namespace raylab::cli {
namespace {

std::atomic<bool> interrupt_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void on_interrupt(int signal) {
  interrupt_asked = true;
  std::signal(signal, SIG_DFL);
}

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
  if (const auto& first = totals.first_non_finite)
    std::cerr << "raylab: warning: " << totals.non_finite_pixels << " pixels are not finite numbers, the first at "
              << first->column << ',' << first->row
              << " (they are black in 8 bits): a task or a formula divides by zero somewhere\n";
  return totals;
}

Image watched_image(const Engine& engine, ImageSize size, unsigned threads, const std::string& what) {
  Image image(size.width, size.height);
  watched_render(engine, size, threads, what, [&](int first_row, std::span<const Color> rows) {
    std::copy(rows.begin(), rows.end(), &image.at(0, first_row));
  });
  return image;
}

}  // namespace raylab::cli
