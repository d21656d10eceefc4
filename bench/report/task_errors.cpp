#include "bench/report/task_errors.hpp"

#include <cmath>
#include <limits>

namespace raylab::bench {
namespace {

/// The unit in the last place of a number of that size.
double ulp(double size, Precision precision) {
  const bool single = precision == Precision::f32;
  const int least_exponent = single ? std::numeric_limits<float>::min_exponent - 1 : -1022;
  const int exponent = size > 0 ? std::max(std::ilogb(size), least_exponent) : least_exponent;
  return std::scalbn(1.0, exponent - (single ? 23 : 52));
}

/// Of vectors whose squares may vanish or overflow, too.
double length_of(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

/// Has the answer other parts than the truth, or made something of nothing?
bool decides_otherwise(const Answer& truth, const Answer& answer) {
  if (answer.decisions != truth.decisions) return true;
  for (std::size_t k = 0; k < truth.numbers.size(); ++k)
    if (!truth.numbers[k].is_point && truth.numbers[k].value == Vec3(0) && answer.numbers[k].value != Vec3(0)) return true;
  return false;
}

/// How far part k of an answer is from the true one.
double ulps_between(const Truth& truth, const Answer& answer, std::size_t k, Precision precision) {
  const Answer::Number& right = truth.answer.numbers[k];
  if (answer.numbers[k].value == right.value) return 0;
  const double size = std::max(length_of(right.value), right.is_point ? truth.point_scale : 0);
  return length_of(answer.numbers[k].value - right.value) / ulp(size, precision);
}

/// The greatest ulps by which part k moves, at least 1; nothing where each move has changed a decision, so that none says
/// how far.
std::optional<double> condition(const Truth& truth, std::size_t k, Precision precision) {
  const double move = precision == Precision::f32 ? 1 : 0.5;  // moved() goes a whole ulp in double
  std::optional<double> most;
  for (const Answer& moved : truth.moved)
    if (is_finite(moved) && !decides_otherwise(truth.answer, moved))
      most = std::max(most.value_or(1), move * ulps_between(truth, moved, k, precision));
  return most;
}

}  // namespace

bool is_finite(const Answer& answer) {
  return std::all_of(answer.numbers.begin(), answer.numbers.end(),
                     [](const Answer::Number& number) { return raylab::is_finite(number.value); });
}

double rounded(double x, Precision precision) { return precision == Precision::f32 ? static_cast<float>(x) : x; }

double moved(double x, Precision precision, std::mt19937_64& chance) {
  const bool up = (chance() >> 63) != 0;
  if (!std::isfinite(x) || x == 0) return x;
  if (precision == Precision::f64) return std::nextafter(x, up ? HUGE_VAL : -HUGE_VAL);
  const double half = ulp(std::abs(x), precision) / 2;
  return up ? x + half : x - half;
}

void settle(const Sphere& sphere, Hit& hit) {
  const double outwards = hit.leaves.side == Side::outwards ? 1 : -1;
  hit.point = sphere.center + outwards * sphere.radius * unit(hit.normal);
}

std::vector<double> conditions_of(const Truths& truths, Precision precision) {
  std::vector<double> conditions;
  for (const std::optional<Truth>& truth : truths) {
    std::optional<double> most;
    if (truth)
      for (std::size_t k = 0; k < truth->answer.numbers.size(); ++k)
        if (const auto of_part = condition(*truth, k, precision)) most = std::max(most.value_or(1), *of_part);
    if (most) conditions.push_back(*most);
  }
  return conditions;
}

TaskErrors errors_of(const Truths& truths, std::span<const Answer> answers, Precision precision) {
  TaskErrors errors;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    if (!truths[i]) continue;
    const Truth& truth = *truths[i];
    ++errors.answers;
    if (!is_finite(answers[i])) {
      ++errors.non_finite;
      continue;
    }
    if (decides_otherwise(truth.answer, answers[i])) {
      ++errors.wrong_decisions;
      continue;
    }
    double worst = 0;
    for (std::size_t k = 0; k < truth.answer.numbers.size(); ++k) {
      const double ulps = ulps_between(truth, answers[i], k, precision);
      worst = std::max(worst, ulps);
      if (const auto explained = condition(truth, k, precision))
        errors.unexplained = std::max(errors.unexplained, ulps / *explained);
    }
    if (!truth.answer.numbers.empty()) errors.ulps.push_back(worst);
  }
  return errors;
}

}  // namespace raylab::bench
