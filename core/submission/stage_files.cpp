#include "core/submission/stage_files.hpp"

#include "core/render/stage_table.hpp"
#include "core/scene/nearest_name.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace raylab {

namespace fs = std::filesystem;

Chosen parse_chosen(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || fs::is_directory(text)) return {text, {}};
  Chosen chosen{text.substr(0, colon), {}};
  for (std::size_t start = colon + 1; start <= text.size();) {
    const std::string selection = text.substr(start, text.find(',', start) - start);
    const auto tasks = task_list();
    if (std::none_of(tasks.begin(), tasks.end(), [&](const TaskInfo& task) { return selects(selection, task.label); }))
      throw std::invalid_argument("--with " + text + ": there is no stage or task '" + selection +
                                  "': 'raylab stages' lists them");
    chosen.selections.push_back(selection);
    start += selection.size() + 1;
  }
  return chosen;
}

std::string stage_file(int stage) { return std::string(stage_info(stage).folder) + ".cpp"; }

std::map<int, fs::path> stage_files(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is no folder; a submission is a folder with " + stage_file(1) +
                             " and so on. 'raylab new' makes one");
  std::map<int, fs::path> files;
  for (const StageInfo& stage : stage_list())
    if (const fs::path file = (folder / stage_file(stage.number)).lexically_normal(); fs::is_regular_file(file))
      files[stage.number] = file;
  if (!files.empty()) return files;
  std::string names;
  for (const StageInfo& stage : stage_list()) names += " " + stage_file(stage.number);
  throw std::runtime_error(folder.string() + ": has none of the files that a submission may have:" + names);
}

std::vector<std::string> misnamed_files(const Chosen& chosen) {
  const std::map<int, fs::path> files = stage_files(chosen.folder);
  std::vector<std::string> names;
  for (const StageInfo& stage : stage_list()) names.push_back(stage_file(stage.number));
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::vector<std::string> warnings;
  for (const auto& entry : fs::directory_iterator(chosen.folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".cpp" || std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (const std::string_view nearest = nearest_name(name, known); !nearest.empty())
      warnings.push_back(entry.path().lexically_normal().string() + " is not used: is it to be " + std::string(nearest) +
                         "?");
  }
  for (const StageInfo& stage : stage_list())
    if (!chosen.selections.empty() && !chosen_tasks(chosen, stage.number).empty() && !files.contains(stage.number))
      throw std::runtime_error(chosen.folder.string() + ": has no " + stage_file(stage.number) +
                               ", of which --with names something" + (warnings.empty() ? "" : "; " + warnings.front()));
  return warnings;
}

std::vector<std::string> chosen_tasks(const Chosen& chosen, int stage) {
  std::vector<std::string> labels;
  for (const TaskInfo& task : task_list()) {
    const auto selected = [&](const std::string& selection) { return selects(selection, task.label); };
    const auto& all = chosen.selections;
    if (stage_of(task.label) == stage && (all.empty() || std::any_of(all.begin(), all.end(), selected)))
      labels.emplace_back(task.label);
  }
  return labels;
}

}  // namespace raylab
