#include "tests/hints/probes.hpp"

#include "core/calls/call_task.hpp"
#include "core/explain/recording.hpp"
#include "tests/mistakes/mistakes.hpp"
#include "tests/runner.hpp"
#include "tests/selection.hpp"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <set>
#include <variant>

namespace raylab::test {
namespace {

constexpr std::size_t spread_probes = 150;  // beside those that tell mistakes apart

/// What unit tests need not ask, since it is wrong answers that it tells apart.
const std::map<std::string_view, std::vector<std::string>> more_inputs{
    {"3.6", {R"({"contributions":[[0.5,0.25,0.125],[0.0625,0.5,0.25],[0.125,0.0625,0.03125]]})"}},
    {"5.3", {R"({"bounce":9,"max_bounces":5,"weight":0.5})", R"({"bounce":4,"max_bounces":5,"weight":0.25})"}},
};

/// All that the task's unit tests ask.
std::vector<std::string> inputs_of_tests(const StageTable& solution, std::string_view label) {
  std::set<std::string> seen;
  std::vector<std::string> inputs;
  const auto add = [&](const std::string& arguments) {
    if (seen.insert(arguments).second) inputs.push_back(arguments);
  };
  if (const auto more = more_inputs.find(label); more != more_inputs.end())
    std::for_each(more->second.begin(), more->second.end(), add);
  run_tests(tests_of(label), start_recording(solution), "/dev/null");
  for (const Event& event : stop_recording())
    if (const auto* call = std::get_if<RecordedCall>(&event))
      if (call->task->label == label) add(call->arguments);
  return inputs;
}

/// The answers of the solution and of each known mistake in a task.
std::vector<std::vector<Answer>> known_answers(const StageTable& solution, const TaskInfo& task,
                                               const std::vector<std::string>& inputs) {
  std::vector<std::vector<Answer>> all{answers(task, inputs, solution)};
  for (const Mistake& mistake : known_mistakes()) {
    if (mistake.task != task.label || mistake.shows == Shows::nowhere) continue;
    all.push_back(answers(task, inputs, with(mistake, solution)));
  }
  return all;
}

/// The places of inputs of which each pair of answers that differ anywhere differs in one.
std::set<std::size_t> telling_apart(const std::vector<std::vector<Answer>>& known) {
  std::set<std::size_t> chosen;
  for (std::size_t a = 0; a < known.size(); ++a)
    for (std::size_t b = a + 1; b < known.size(); ++b) {
      const auto differ = [&](std::size_t k) { return !alike(known[a][k], known[b][k]); };
      if (std::any_of(chosen.begin(), chosen.end(), differ)) continue;
      for (std::size_t k = 0; k < known[a].size(); ++k)
        if (differ(k)) {
          chosen.insert(k);
          break;
        }
    }
  return chosen;
}

std::vector<std::string> chosen_inputs(const StageTable& solution, std::string_view label) {
  const std::vector<std::string> inputs = inputs_of_tests(solution, label);
  std::set<std::size_t> places = telling_apart(known_answers(solution, task_info(label), inputs));
  const std::size_t step = std::max<std::size_t>(1, inputs.size() / spread_probes);
  for (std::size_t k = 0; k < inputs.size(); k += step) places.insert(k);
  std::vector<std::string> chosen;
  for (const std::size_t k : places) chosen.push_back(inputs[k]);
  return chosen;
}

}  // namespace

bool alike(const Answer& a, const Answer& b) {
  if (!a.error.empty() || !b.error.empty()) return !a.error.empty() && !b.error.empty();
  return answers_agree(a.json, b.json);
}

std::vector<Answer> answers(const TaskInfo& task, const std::vector<std::string>& inputs, const AskTask& ask) {
  std::vector<Answer> all;
  for (const std::string& arguments : inputs) try {
      all.push_back({ask(task, arguments), {}});
    } catch (const std::exception& error) {
      all.push_back({{}, error.what()});
    }
  return all;
}

std::vector<Answer> answers(const TaskInfo& task, const std::vector<std::string>& inputs, const StageTable& table) {
  const TaskCaller caller(table, task);
  return answers(task, inputs, [&](const TaskInfo&, const std::string& arguments) { return caller.result(arguments); });
}

Probes find_probes(const StageTable& solution, const std::vector<std::string_view>& labels) {
  Probes probes;
  for (const std::string_view label : labels) probes[label] = chosen_inputs(solution, label);
  return probes;
}

}  // namespace raylab::test
