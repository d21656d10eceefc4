#pragma once

#include "bench/report/walk_value.hpp"
#include "core/calls/call_function.hpp"
#include "core/math/shapes.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace raylab::bench {

/// A task's arguments, kept: a list for a span.
template <class Function>
struct ArgumentsOf;
template <class Result, class... Parameters>
struct ArgumentsOf<Result (*)(Parameters...)> {
  using Type = std::tuple<typename Kept<Parameters>::Type...>;
};
template <class Function>
using Arguments = typename ArgumentsOf<Function>::Type;

/// What a task has answered, taken apart.
struct Answer {
  struct Number {
    Vec3 value;  ///< a single number is the first component, the others are 0
    bool is_point = false;
  };
  std::vector<Number> numbers;
  std::vector<long> decisions;  ///< hit or miss, a place in a list, the side of a surface, ...
};

/// Has it no number that is infinite or NaN?
bool is_finite(const Answer& answer);

/// The right answer to one input, and what it becomes when the input is rounded otherwise.
struct Truth {
  Answer answer;
  std::vector<Answer> moved;  ///< the right answers to inputs moved at random by at most one rounding
  double point_scale = 0;     ///< the least size by which an error of a point is measured: see errors_of()
};

/// One input's entry is empty where there is no right answer, or none that is finite.
using Truths = std::vector<std::optional<Truth>>;

/// How many ulps the true result moves, if it were computed exactly of inputs that are rounded otherwise: half an ulp
/// of `precision` to either side. One number for each input, at least 1: of the part of the answer that moves most.
/// Vectors that a contract calls unit are so to the oracle, which divides them by their length; that they cannot be quite of
/// length 1 is not in it, and can leave an unexplained error of some 30 in the best of formulas.
std::vector<double> conditions_of(const Truths& truths, Precision precision);

/// What is wrong with a function's answers.
struct TaskErrors {
  std::size_t answers = 0;          ///< how many have been judged
  std::size_t wrong_decisions = 0;  ///< of these, answers that decide otherwise than the truth; nothing else of them counts
  std::size_t non_finite = 0;       ///< answers with a number that is not finite
  std::vector<double> ulps;         ///< of every other answer that has numbers: of its part that is worst
  double unexplained = 0;           ///< the greatest of ulps / condition, part by part
};

/// Judges answers, one for each truth.
///
/// An error is counted in ulps: units in the last place, in `precision`, of the true number, and of a vector's true length.
/// A point's may be longer, since a point near the origin of the world is no better known than what it was computed
/// from: of its length, the distance of the sphere's center from there, and the sphere's radius, the greatest counts. What
/// is not exactly 0 where the truth is 0 has decided wrongly: a light below a surface, say.
TaskErrors errors_of(const Truths& truths, std::span<const Answer> answers, Precision precision);

/// x, or the float nearest to it.
double rounded(double x, Precision precision);

/// A number next to x: half an ulp of f32 away, where there is more room, a whole one of f64; up or down as chance wills.
double moved(double x, Precision precision, std::mt19937_64& chance);

/// Puts a hit's point on its sphere again after its other numbers have been rounded to floats: in double, for the functions
/// to round. A point that is off by a float's rounding is on no ray that grazes the sphere, and the right answer for it far
/// from what is meant.
void settle(const Sphere& sphere, Hit& hit);

// ---- From here on templates that only take types apart --------------------------------------------------------------

/// Calls change(x) for every double x of a task's arguments, and puts the result in its place.
template <class Arguments, class Change>
void change_numbers(Arguments& arguments, Change change) {
  struct Visitor {
    Change& change;
    void number(double& x) { x = change(x); }
    void vector(Vec3& v) { v = Vec3(change(v.x), change(v.y), change(v.z)); }
    void point(Vec3& p) { vector(p); }
    void decision(long) {}
  };
  walk_value(arguments, Visitor{change});
}

template <class Result>
Answer taken_apart(const Result& result) {
  struct Visitor {
    Answer& answer;
    void number(double x) { answer.numbers.push_back({{x, 0, 0}}); }
    void vector(const Vec3& v) { answer.numbers.push_back({v}); }
    void point(const Vec3& p) { answer.numbers.push_back({p, true}); }
    void decision(long k) { answer.decisions.push_back(k); }
  };
  Answer answer;
  walk_value(result, Visitor{answer});
  return answer;
}

template <class Function>
Answer answer_of(Function function, const Arguments<Function>& arguments) {
  return taken_apart(std::apply(function, arguments));
}

template <class Function>
std::vector<Answer> answers_of(Function function, const std::vector<Arguments<Function>>& inputs) {
  std::vector<Answer> answers;
  for (const Arguments<Function>& input : inputs) answers.push_back(answer_of(function, input));
  return answers;
}

/// The inputs that a function of this precision is given.
template <class Arguments>
std::vector<Arguments> rounded(std::vector<Arguments> inputs, Precision precision) {
  for (Arguments& input : inputs) {
    change_numbers(input, [&](double x) { return rounded(x, precision); });
    if constexpr (std::same_as<Arguments, std::tuple<Sphere, double, Hit>>)
      settle(std::get<Sphere>(input), std::get<Hit>(input));
  }
  return inputs;
}

template <class Argument>
double size_of(const Argument& argument) {
  if constexpr (std::same_as<Argument, Sphere>)
    return std::max(length(argument.center), argument.radius);
  else
    return 0;
}

/// The truth by the oracle's function; nothing where that has no answer, or none that is finite.
template <class Function>
std::optional<Truth> truth_of(Function oracle, const Arguments<Function>& input, Precision precision,
                              std::mt19937_64& chance) {
  constexpr int moves = 8;  // the greatest of fewer is often far below what inputs can do
  try {
    Truth truth{answer_of(oracle, input), {}, 0};
    if (!is_finite(truth.answer)) return std::nullopt;
    for (int k = 0; k < moves; ++k) {
      Arguments<Function> elsewhere = input;
      change_numbers(elsewhere, [&](double x) { return moved(x, precision, chance); });
      truth.moved.push_back(answer_of(oracle, elsewhere));
    }
    std::apply([&](const auto&... argument) { ((truth.point_scale = std::max(truth.point_scale, size_of(argument))), ...); },
               input);
    return truth;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

/// The truths for inputs that are rounded to `precision` already; about a millisecond for each. Throws Cancelled soon after
/// `cancel` is set.
template <class Function>
Truths truths_of(Function oracle, const std::vector<Arguments<Function>>& inputs, Precision precision,
                 const std::atomic<bool>& cancel) {
  std::mt19937_64 chance(1);
  Truths truths;
  for (const Arguments<Function>& input : inputs) {
    if (cancel) throw Cancelled{};
    truths.push_back(truth_of(oracle, input, precision, chance));
  }
  return truths;
}

}  // namespace raylab::bench
