#include "tests/hints/hints.hpp"

#include "core/explain/formulas.hpp"
#include "core/explain/handbook.hpp"
#include "tests/hints/observed.hpp"
#include "tests/mistakes/mistakes.hpp"

#include <algorithm>
#include <optional>

namespace raylab::test {
namespace {

bool all_alike(const std::vector<Answer>& a, const std::vector<Answer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), alike);
}

/// The failing probe that is quickest to work by hand: the shortest.
const WrongAnswer& simplest(const std::vector<WrongAnswer>& wrong) {
  return *std::min_element(wrong.begin(), wrong.end(), [](const WrongAnswer& a, const WrongAnswer& b) {
    return a.arguments.size() + a.wanted.size() < b.arguments.size() + b.wanted.size();
  });
}

std::string observed(const TaskInfo& task, const std::vector<WrongAnswer>& wrong, std::size_t probes) {
  const WrongAnswer& example = simplest(wrong);
  const std::string pattern = common_pattern(wrong);
  return std::string(task.name) + " answers " + std::to_string(wrong.size()) + " of " + std::to_string(probes) +
         " inputs differently." + (pattern.empty() ? "" : " " + pattern) + " For example\n      raylab call " +
         std::string(task.label) + " '" + example.arguments + "'\n      gives " +
         (example.error.empty() ? example.got : example.error) + "\n      in place of " + example.wanted;
}

std::string where_to_look(const TaskInfo& task) {
  const StageInfo& stage = stage_info(stage_of(task.label));
  const Formula formula = formula_of(task.label);
  std::string text =
      in_handbook(std::string(stage.folder) + "/README.md") + ", " + std::string(task.label) + " " + std::string(task.name);
  if (!formula.formula.empty())
    text += ": " + std::string(formula.formula) + " (handout, " + std::string(formula.handout) + ")";
  return text +
         ". Work the example by hand beside your code, line by line: which intermediate value is the first to differ?";
}

}  // namespace

std::vector<Hint> find_hints(const StageTable& solution, const AskTask& ask, const Probes& probes) {
  std::vector<Hint> hints;
  std::vector<StageTable> named;  // tables with the mistakes that have been named
  for (const auto& of_task : probes) {
    const std::string_view label = of_task.first;
    const std::vector<std::string>& inputs = of_task.second;
    const TaskInfo& task = task_info(label);
    const std::vector<Answer> wanted = answers(task, inputs, solution);
    const std::vector<Answer> got = answers(task, inputs, ask);
    std::vector<WrongAnswer> wrong;
    for (std::size_t k = 0; k < inputs.size(); ++k)
      if (!alike(wanted[k], got[k])) wrong.push_back({inputs[k], wanted[k].json, got[k].json, got[k].error});
    if (wrong.empty()) continue;
    const auto has_answer = [](const Answer& answer) { return answer.error.empty(); };
    if (std::none_of(got.begin(), got.end(), has_answer)) {
      hints.push_back({&task, "it answers nothing: " + got.front().error, where_to_look(task), {}});
      continue;
    }
    // What an earlier task's mistake brings along is no mistake of this task.
    const auto explains = [&](const StageTable& table) { return all_alike(answers(task, inputs, table), got); };
    if (std::any_of(named.begin(), named.end(), explains)) continue;

    Hint hint{&task, observed(task, wrong, inputs.size()), where_to_look(task), {}};
    for (const Mistake& mistake : known_mistakes()) {
      if (mistake.task != label || mistake.shows == Shows::nowhere) continue;
      const StageTable table = with(mistake, solution);
      if (!explains(table)) continue;
      hint.mistake += (hint.mistake.empty() ? "" : ", or: ") + std::string(mistake.name);
      named.push_back(table);
    }
    hints.push_back(hint);
  }
  return hints;
}

std::string hints_text(const std::vector<Hint>& hints, int level) {
  std::string text;
  for (const Hint& hint : hints) {
    text += "Hint on " + std::string(hint.task->label) + ' ' + std::string(hint.task->name) +
            "\n  1 observed: " + hint.observed + '\n';
    if (level >= 2) text += "  2 look at: " + hint.look + '\n';
    if (level >= 3)
      text += "  3 mistake: " + (hint.mistake.empty() ? "none that is known answers like this" : hint.mistake) + '\n';
  }
  return text;
}

}  // namespace raylab::test
