#include "core/render/render.hpp"

#include "core/render/thread_seconds.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <ctime>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace raylab {
namespace {

constexpr int band_rows = 8;

/// The pixels of some rows that are no finite numbers.
struct NonFinite {
  std::uint64_t count = 0;
  PixelPlace first{};
};

/// Of numbers from 0 to 1 none has the highest bit of the exponent, which all from 2 on have, infinity and NaN too: so it
/// takes less than one operation a number to find out that there is nothing to be found.
bool may_be_non_finite(std::span<const Color> pixels) {
  static_assert(sizeof(Color) == 3 * sizeof(double));
  const std::span numbers(&pixels.front().x, 3 * pixels.size());
  std::array<std::uint64_t, 8> all{};  // side by side: one would wait for itself
  std::size_t k = 0;
  for (; k + all.size() <= numbers.size(); k += all.size())
    for (std::size_t i = 0; i < all.size(); ++i) all[i] |= std::bit_cast<std::uint64_t>(numbers[k + i]);
  for (; k < numbers.size(); ++k) all[0] |= std::bit_cast<std::uint64_t>(numbers[k]);
  return std::any_of(all.begin(), all.end(), [](std::uint64_t bits) { return (bits >> 62 & 1) != 0; });
}

NonFinite find_non_finite(std::span<const Color> pixels, int first_row, int width) {
  NonFinite found;
  if (!may_be_non_finite(pixels)) return found;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    if (is_finite(pixels[k])) continue;
    const int place = static_cast<int>(k);
    if (found.count++ == 0) found.first = {place % width, first_row + place / width};
  }
  return found;
}

/// The bands of an image on their way from the threads that compute them to the one that wants them in order.
class Bands {
 public:
  Bands(const Engine& engine, ImageSize size, unsigned threads, const std::atomic<bool>& cancel)
      : engine_(engine),
        size_(size),
        count_((size.height + band_rows - 1) / band_rows),
        ahead_(static_cast<int>(4 * threads)),
        worth_waking_(2 * threads),
        cancel_(cancel) {
    start_threads(std::min(threads, static_cast<unsigned>(count_)));
  }

  ~Bands() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    taken_changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  Bands(const Bands&) = delete;
  Bands& operator=(const Bands&) = delete;

  int count() const { return count_; }

  /// The pixels of a band, once they are there; meanwhile calls `waiting` every 50 ms. Bands are taken in order, and valid
  /// until the next is.
  template <class Waiting>
  std::span<const Color> take(int band, Waiting waiting) {
    std::unique_lock lock(mutex_);
    if (taken_ > 0) spare_.push_back(std::move(newest_taken_));
    while (!finished_.contains(band) && !failure_ && !cancel_) {
      finished_changed_.wait_for(lock, std::chrono::milliseconds(50));
      lock.unlock();
      waiting();
      lock.lock();
    }
    if (failure_) std::rethrow_exception(failure_);
    if (cancel_) throw Cancelled{};
    taken_ = band + 1;
    taken_changed_.notify_all();
    newest_taken_ = std::move(finished_.extract(band).mapped());
    return newest_taken_;
  }

  double done() const { return static_cast<double>(rows_done_) / size_.height; }

  RenderTotals totals() {
    const std::lock_guard lock(mutex_);
    return totals_;
  }

 private:
  /// As many threads as the system gives, one at least.
  void start_threads(unsigned wanted) {
    threads_.reserve(wanted);
    try {
      while (threads_.size() < wanted) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      if (threads_.empty()) throw;
    }
  }

  void work() {
    try {
      for (int band = next_++; band < count_; band = next_++) {
        wait_for_turn(band);
        if (stop_) return;
        compute(band);
      }
    } catch (const Cancelled&) {
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stop_ = true;
      finished_changed_.notify_one();
      taken_changed_.notify_all();
    }
  }

  /// Keeps a thread from running far ahead of a slow band: finished bands wait in memory.
  void wait_for_turn(int band) {
    std::unique_lock lock(mutex_);
    taken_changed_.wait(lock, [&] { return stop_ || band < taken_ + ahead_; });
  }

  void compute(int band) {
    const int first_row = band * band_rows;
    const int rows = std::min(band_rows, size_.height - first_row);
    const auto width = static_cast<std::size_t>(size_.width);
    std::vector<Color> pixels = spare();
    pixels.resize(static_cast<std::size_t>(rows) * width);
    RayCounts counts;
    const double start = thread_seconds();
    for (int row = 0; row < rows;) {
      const int some = std::min(engine_.rows_at_once(), rows - row);
      const auto at = static_cast<std::size_t>(row) * width, length = static_cast<std::size_t>(some) * width;
      engine_.trace_rows(first_row + row, std::span(pixels).subspan(at, length), counts, stop_);
      rows_done_ += some;
      row += some;
    }
    const double took = thread_seconds() - start;
    const NonFinite non_finite = find_non_finite(pixels, first_row, size_.width);
    const std::lock_guard lock(mutex_);
    add(non_finite);
    totals_.rays += counts;
    totals_.trace_seconds += took;
    finished_.emplace(band, std::move(pixels));
    if (finished_.size() >= worth_waking_ || rows_done_ == size_.height) finished_changed_.notify_one();
  }

  /// Memory that was used before, if there is some: to get new pages from the system takes longer than to fill them.
  std::vector<Color> spare() {
    const std::lock_guard lock(mutex_);
    if (spare_.empty()) return {};
    std::vector<Color> pixels = std::move(spare_.back());
    spare_.pop_back();
    return pixels;
  }

  /// Bands end in any order.
  void add(const NonFinite& found) {
    if (found.count == 0) return;
    totals_.non_finite_pixels += found.count;
    std::optional<PixelPlace>& first = totals_.first_non_finite;
    if (!first || found.first.row < first->row) first = found.first;
  }

  const Engine& engine_;
  const ImageSize size_;
  const int count_;
  const int ahead_;
  const std::size_t worth_waking_;  // so many finished bands; a short frame is slower by a twentieth if each one wakes
  const std::atomic<bool>& cancel_;
  std::atomic<bool> stop_ = false;
  std::atomic<int> next_ = 0;
  std::atomic<int> rows_done_ = 0;
  std::mutex mutex_;  // guards what follows
  std::condition_variable finished_changed_, taken_changed_;
  std::map<int, std::vector<Color>> finished_;
  std::vector<Color> newest_taken_;
  std::vector<std::vector<Color>> spare_;
  int taken_ = 0;
  RenderTotals totals_;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace

RenderTotals render(const Engine& engine, ImageSize size, unsigned threads, const RowSink& sink, const Progress& progress,
                    const std::atomic<bool>& cancel) {
  Bands bands(engine, size, std::max(1u, threads), cancel);
  for (int band = 0; band < bands.count(); ++band) {
    const std::span<const Color> pixels = bands.take(band, [&] { progress(bands.done()); });
    sink(band * band_rows, pixels);
    progress(bands.done());
  }
  return bands.totals();
}

Image render_image(const Engine& engine, ImageSize size, unsigned threads, const Progress& progress,
                   const std::atomic<bool>& cancel) {
  Image image(size.width, size.height);
  const auto keep = [&](int first_row, std::span<const Color> rows) {
    std::copy(rows.begin(), rows.end(), &image.at(0, first_row));
  };
  render(engine, size, threads, keep, progress, cancel);
  return image;
}

Image render_image(const Engine& engine, ImageSize size, unsigned threads) {
  const std::atomic<bool> never = false;
  return render_image(
      engine, size, threads, [](double) {}, never);
}

}  // namespace raylab
