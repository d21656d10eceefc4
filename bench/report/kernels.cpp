#include "bench/report/kernels.hpp"

#include "bench/report/race.hpp"
#include "bench/report/task_errors.hpp"
#include "bench/report/task_inputs.hpp"
#include "bench/report/textbook_tasks.hpp"
#include "reference/engine/tasks.hpp"
#include "reference/oracle/tasks.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>

namespace raylab::bench {
namespace {

/// How much is done for a family.
struct Effort {
  std::size_t inputs;
  int rounds;
  double least_seconds;  ///< of a round of one contender
  double seconds;        ///< in all, about
};

Effort effort_of(const Plan& plan) { return plan.quick ? Effort{32, 3, 0.002, 0.15} : Effort{256, 9, 0.01, 1.5}; }

/// One implementation in one precision.
template <class Function>
struct Contender {
  const char* by;
  Precision precision;
  Function function;
};

constexpr std::size_t contender_count = 5;
template <class Function>
using Contenders = std::array<Contender<Function>, contender_count>;

const char* name_of(Precision precision) { return precision == Precision::f32 ? "f32" : "f64"; }

/// A function that calls another one with each input. It is fetched from where the compiler cannot know that it still is
/// the same: so no call is left out, inlined or done once for all.
///
/// The fast engine's tasks convert each input, and prepare a camera, a plane, a finish for every call, which the engine does
/// once for a scene: their time is an upper bound of what the formula costs there.
template <class Function>
std::function<void()> calls_of(Function function, const std::vector<Arguments<Function>>& inputs) {
  return [function, &inputs] {
    Function volatile hidden = function;
    for (const Arguments<Function>& input : inputs) std::apply(hidden, input);
  };
}

/// What one call takes of each contender, in ns.
template <class Function>
std::array<Json, contender_count> times_of(const Contenders<Function>& contenders,
                                           const std::vector<Arguments<Function>>& inputs, const Effort& effort,
                                           const std::atomic<bool>& cancel) {
  std::vector<std::function<void()>> runs;
  for (const Contender<Function>& contender : contenders) runs.push_back(calls_of(contender.function, inputs));
  std::vector<std::vector<double>> seconds = race(runs, effort.rounds, effort.least_seconds, cancel);
  std::array<Json, contender_count> times;
  for (std::size_t k = 0; k < contender_count; ++k) {
    for (double& time : seconds[k]) time *= 1e9 / static_cast<double>(inputs.size());
    times[k] = spread(std::move(seconds[k]));
  }
  return times;
}

/// {"median", "max"}, or null for no values.
Json median_and_max(std::vector<double> values) {
  if (values.empty()) return nullptr;
  const Json all = spread(values);
  return {{"median", all["median"]}, {"max", *std::max_element(values.begin(), values.end())}};
}

Json errors_as_json(const TaskErrors& errors) {
  Json json = {{"ulps", median_and_max(errors.ulps)},
               {"answers", errors.answers},
               {"wrong_decisions", errors.wrong_decisions},
               {"non_finite", errors.non_finite},
               {"unexplained", nullptr}};
  if (!errors.ulps.empty()) json["unexplained"] = errors.unexplained;
  return json;
}

/// The truth about a family's inputs, rounded to a precision.
template <class Function>
struct Judge {
  Precision precision;
  std::vector<Arguments<Function>> inputs;
  Truths truths;

  Judge(const Family<Function>& family, Function oracle, Precision precision_, const std::atomic<bool>& cancel)
      : precision(precision_),
        inputs(rounded(family.inputs, precision)),
        truths(truths_of(oracle, inputs, precision, cancel)) {}

  TaskErrors errors(Function function) const { return errors_of(truths, answers_of(function, inputs), precision); }
};

/// The family's entry in the report.
template <class Function>
Json measured(const Family<Function>& family, const Contenders<Function>& contenders, Function oracle, const Effort& effort,
              const std::atomic<bool>& cancel) {
  const Judge<Function> f32(family, oracle, Precision::f32, cancel), f64(family, oracle, Precision::f64, cancel);
  const std::array<Json, contender_count> times = times_of(contenders, family.inputs, effort, cancel);
  Json results = Json::array();
  for (std::size_t k = 0; k < contender_count; ++k) {
    const auto& [by, precision, function] = contenders[k];
    Json result = {{"by", by}, {"precision", name_of(precision)}, {"ns", times[k]}};
    result.update(errors_as_json((precision == Precision::f32 ? f32 : f64).errors(function)));
    results.push_back(std::move(result));
  }
  return {{"family", family.name},
          {"hard", family.hard},
          {"inputs", family.inputs.size()},
          {"text", family.text},
          {"condition", median_and_max(conditions_of(f64.truths, Precision::f64))},
          {"results", std::move(results)}};
}

std::string unit_name(std::string_view task, const std::string& family) {
  return "kernels/" + std::string(task) + "/" + family;
}

struct Tables {
  StageTable textbook_f32, textbook_f64, solution, fast_f32, fast_f64, oracle;
};

template <class Function>
Unit unit_of(const char* label, const Family<Function>& family, const Tables& tables, Function StageTable::*task,
             const Effort& effort) {
  const Contenders<Function> contenders = {{{"textbook", Precision::f32, tables.textbook_f32.*task},
                                            {"textbook", Precision::f64, tables.textbook_f64.*task},
                                            {"solution", Precision::f64, tables.solution.*task},
                                            {"fast", Precision::f32, tables.fast_f32.*task},
                                            {"fast", Precision::f64, tables.fast_f64.*task}}};
  return {unit_name(label, family.name), effort.seconds,
          [family, contenders, oracle = tables.oracle.*task, effort](const std::atomic<bool>& cancel) {
            return measured(family, contenders, oracle, effort, cancel);
          }};
}

}  // namespace

std::vector<Unit> kernel_units(const Plan& plan, const StageTable& solution) {
  const Tables tables{textbook_table(Precision::f32), textbook_table(Precision::f64), solution,
                      fast_table(Precision::f32),     fast_table(Precision::f64),     oracle_table()};
  const Effort effort = effort_of(plan);
  std::vector<Unit> units;
  for_each_task(task_families(effort.inputs),
                [&](const char* label, const char*, const char*, const auto& families, auto task) {
                  for (const auto& family : families) units.push_back(unit_of(label, family, tables, task, effort));
                });
  return units;
}

Json kernel_report(const Results& results) {
  Json section = Json::array();
  for_each_task(task_families(1), [&](const char* label, const char* name, const char* summary, const auto& families, auto) {
    Json entries = Json::array();
    for (const auto& family : families)
      if (const auto found = results.find(unit_name(label, family.name)); found != results.end())
        entries.push_back(found->second);
    if (!entries.empty())
      section.push_back({{"task", label}, {"name", name}, {"summary", summary}, {"families", std::move(entries)}});
  });
  return section;
}

}  // namespace raylab::bench
