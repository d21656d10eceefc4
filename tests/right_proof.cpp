// Proves of right submissions in unusual styles, tests/submissions/right, that they pass all that a submission is asked: the
// unit tests of each task and the images of each stage. Exit code 1 if one does not.
//   raylab-right-proof           all of them
//   raylab-right-proof STYLE...  those

#include "core/render/stages_engine.hpp"
#include "right_styles.hpp"
#include "tests/runner.hpp"
#include "tests/selection.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#define RAYLAB_DECLARE(style) extern "C" const raylab::ExportedTasks* raylab_tasks_##style();
RAYLAB_RIGHT_STYLES(RAYLAB_DECLARE)

using namespace raylab;

namespace {

struct Style {
  std::string_view name;
  const ExportedTasks* tasks;
};

#define RAYLAB_LIST(style) {#style, raylab_tasks_##style()},
const std::vector<Style> all_styles{RAYLAB_RIGHT_STYLES(RAYLAB_LIST)};

std::string all_tests() {
  std::string all;
  for (const TaskInfo& task : task_list()) all += (all.empty() ? "" : ",") + test::tests_of_submission(task.label);
  for (const StageInfo& stage : stage_list()) all += ",[stage" + std::to_string(stage.number) + "][references]";
  return all;
}

/// Prints what fails.
bool passes(const Style& style) {
  const StageTable table = import_tasks(*style.tasks);
  const test::TemporaryFolder folder;
  const auto images = [&](const Scene& scene, const Settings& settings) { return make_stages(scene, settings, table); };
  const test::Totals totals = test::run_tests(all_tests(), table, images, folder / "report");
  std::cout << style.name << ": " << totals.passed << " passed, " << totals.failed << " failed\n";
  if (totals.failed > 0) std::cout << test::bytes_of(folder / "report");
  return totals.failed == 0 && totals.passed > 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> asked(argv + 1, argv + argc);
  bool all_pass = true;
  std::size_t count = 0;
  for (const Style& style : all_styles) {
    if (!asked.empty() && std::find(asked.begin(), asked.end(), style.name) == asked.end()) continue;
    all_pass = passes(style) && all_pass;
    ++count;
  }
  if (count < std::max<std::size_t>(1, asked.size())) {
    std::cerr << "there is no such style\n";
    return 2;
  }
  return all_pass ? 0 : 1;
}
