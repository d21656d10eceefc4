#include "tests/hints/probes.hpp"

#include "core/explain/recording.hpp"
#include "tests/runner.hpp"
#include "tests/selection.hpp"

#include <cstddef>
#include <set>
#include <variant>

namespace raylab::test {
namespace {

constexpr std::size_t most = 400;  // of a task: each is a call of another process

/// Some of them, evenly over the list.
std::vector<std::string> thinned(const std::vector<std::string>& all) {
  if (all.size() <= most) return all;
  std::vector<std::string> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(all[k * all.size() / most]);
  return some;
}

}  // namespace

Probes find_probes(const StageTable& solution, const std::vector<std::string_view>& labels) {
  Probes probes;
  for (const std::string_view label : labels) {
    run_tests(tests_of(label), start_recording(solution), "/dev/null");
    std::set<std::string> seen;
    std::vector<std::string> arguments;
    for (const Event& event : stop_recording())
      if (const auto* call = std::get_if<RecordedCall>(&event))
        if (call->task->label == label && seen.insert(call->arguments).second) arguments.push_back(call->arguments);
    probes[label] = thinned(arguments);
  }
  return probes;
}

}  // namespace raylab::test
