#include "core/render/stage_table.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <typeinfo>

namespace raylab {
namespace {

constexpr StageInfo all_stages[] = {
#define RAYLAB_STAGE(number, name, folder) {number, name, folder},
    RAYLAB_STAGES(RAYLAB_STAGE)
#undef RAYLAB_STAGE
};

constexpr TaskInfo all_tasks[] = {
#define RAYLAB_TASK(label, function, summary, example) {label, #function, summary, example},
    RAYLAB_TASKS(RAYLAB_TASK)
#undef RAYLAB_TASK
};

/// Leaves `function` as it is if the task is not there.
template <class Function>
void import_task(const ExportedTasks& exported, std::string_view label, Function& function) {
  const std::span tasks(exported.tasks, exported.count);
  const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const ExportedTask& t) { return t.label == label; });
  if (found == tasks.end() || !found->function) return;
  if (std::string_view(found->signature) != typeid(std::remove_pointer_t<Function>).name())
    throw std::runtime_error("task " + std::string(label) + " takes or returns other types than its contract says");
  function = reinterpret_cast<Function>(found->function);
}

/// Nothing for what is not all digits.
std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && text.find('-') == text.npos;
  return whole ? std::optional(value) : std::nullopt;
}

template <class Function>
void add_filter(std::vector<RayFilter>& filters, Function function) {
  if constexpr (std::is_same_v<Function, RayFilter>) filters.push_back(function);
}

}  // namespace

std::span<const StageInfo> stage_list() { return all_stages; }

std::span<const TaskInfo> task_list() { return all_tasks; }

const StageInfo& stage_info(int number) { return stage_list()[static_cast<std::size_t>(number - 1)]; }

std::string stage_title(int number) {
  return "stage " + std::to_string(number) + ", " + std::string(stage_info(number).name);
}

const TaskInfo& task_info(std::string_view label) {
  const auto tasks = task_list();
  return *std::find_if(tasks.begin(), tasks.end(), [&](const TaskInfo& task) { return task.label == label; });
}

bool selects(std::string_view selection, std::string_view task_label) {
  const std::size_t dash = std::min(selection.find('-'), selection.size());
  const std::optional<int> first = whole_number(selection.substr(0, dash));
  const std::optional<int> last = dash < selection.size() ? whole_number(selection.substr(dash + 1)) : first;
  const int stage = stage_of(task_label);
  return selection == task_label || (first && last && *first <= stage && stage <= *last);
}

int stage_of(std::string_view task_label) {
  int stage = 0;
  std::from_chars(task_label.data(), task_label.data() + task_label.size(), stage);
  return stage;
}

StageTable import_some_tasks(const ExportedTasks& exported) {
  if (exported.version != contract_version)
    throw std::runtime_error("this implementation was built for version " + std::to_string(exported.version) +
                             " of the contracts, wanted " + std::to_string(contract_version) + ": build it again");
  StageTable table;
#define RAYLAB_IMPORT(label, function, summary, example) import_task(exported, label, table.function);
  RAYLAB_TASKS(RAYLAB_IMPORT)
#undef RAYLAB_IMPORT
  return table;
}

StageTable import_tasks(const ExportedTasks& exported) {
  const StageTable table = import_some_tasks(exported);
#define RAYLAB_REQUIRE(label, function, summary, example) \
  if (!table.function) throw std::runtime_error("task " label " is missing from this implementation");
  RAYLAB_TASKS(RAYLAB_REQUIRE)
#undef RAYLAB_REQUIRE
  return table;
}

void mix(StageTable& table, const StageTable& other, std::string_view selection) {
  bool any = false;
#define RAYLAB_MIX(label, function, summary, example) \
  if (selects(selection, label)) table.function = other.function, any = true;
  RAYLAB_TASKS(RAYLAB_MIX)
#undef RAYLAB_MIX
  if (!any) throw std::invalid_argument("no stage or task is called '" + std::string(selection) + "'");
}

std::vector<RayFilter> ray_filters(const StageTable& table, int last_stage) {
  std::vector<RayFilter> filters;
#define RAYLAB_FILTER(label, function, summary, example) \
  if (stage_of(label) <= last_stage) add_filter(filters, table.function);
  RAYLAB_TASKS(RAYLAB_FILTER)
#undef RAYLAB_FILTER
  return filters;
}

}  // namespace raylab
