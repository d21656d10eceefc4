#pragma once

#include "bench/report/unit.hpp"
#include "core/render/thread_seconds.hpp"

#include <atomic>
#include <functional>
#include <span>
#include <vector>

namespace raylab::bench {

/// A quartile range wider than this part of the median is too noisy to judge by.
inline constexpr double noisy_spread = 0.1;

/// What repeated measurements say: {"median", "low", "high", "rounds", "noisy"}. `low` and `high` are the quartiles; with
/// fewer than 4 values the least and the greatest.
Json spread(std::vector<double> values);

/// Runs the contenders in turn, round after round, so that a machine that drifts slows all of them; each round begins with
/// another one. A contender that takes less than `least_seconds` is run again and again until that is over.
/// Returns the time of one run in seconds, by `clock`: for each contender one number a round, at least three; it runs in no
/// more rounds once it has taken a second over these.
/// Throws Cancelled between two runs once `cancel` is set, and what a contender throws.
std::vector<std::vector<double>> race(std::span<const std::function<void()>> contenders, int rounds, double least_seconds,
                                      const std::atomic<bool>& cancel, double (*clock)() = thread_seconds);

/// The time that passes, in seconds, whoever works.
double wall_seconds();

}  // namespace raylab::bench
