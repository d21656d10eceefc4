#include "bench/report/race.hpp"

#include "core/render/engine.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace raylab::bench {
namespace {

using Clock = double (*)();

double seconds_of(const std::function<void()>& run, long times, Clock clock) {
  const double start = clock();
  for (long i = 0; i < times; ++i) run();
  return clock() - start;
}

// A contender that has taken so long over so many rounds leaves the rest of them to the others.
constexpr int few_rounds = 3;
constexpr double long_seconds = 1;

/// How many runs last `least_seconds`: found by doubling, so that caches are warm when the first round begins.
long repeats(const std::function<void()>& run, double least_seconds, Clock clock) {
  for (long times = 1;; times *= 2)
    if (seconds_of(run, times, clock) >= least_seconds) return times;
}

/// Between the two values that stand next to `place`, from 0 to 1, in a sorted list.
double quantile(const std::vector<double>& sorted, double place) {
  const double at = place * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

}  // namespace

Json spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const bool few = values.size() < 4;
  const double median = quantile(values, 0.5);
  const double low = few ? values.front() : quantile(values, 0.25), high = few ? values.back() : quantile(values, 0.75);
  return {{"median", median},
          {"low", low},
          {"high", high},
          {"rounds", values.size()},
          {"noisy", high - low > noisy_spread * median}};
}

double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::vector<std::vector<double>> race(std::span<const std::function<void()>> contenders, int rounds, double least_seconds,
                                      const std::atomic<bool>& cancel, Clock clock) {
  const auto run = [&](std::size_t k, long times) {
    if (cancel) throw Cancelled{};
    return seconds_of(contenders[k], times, clock);
  };
  std::vector<long> times;
  for (const std::function<void()>& contender : contenders) {
    if (cancel) throw Cancelled{};
    times.push_back(repeats(contender, least_seconds, clock));
  }
  std::vector<std::vector<double>> seconds(contenders.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t turn = 0; turn < contenders.size(); ++turn) {
      const std::size_t k = (turn + static_cast<std::size_t>(round)) % contenders.size();
      if (round >= few_rounds &&
          std::reduce(seconds[k].begin(), seconds[k].end()) * static_cast<double>(times[k]) > long_seconds)
        continue;
      seconds[k].push_back(run(k, times[k]) / static_cast<double>(times[k]));
    }
  return seconds;
}

}  // namespace raylab::bench
