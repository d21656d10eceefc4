#include "core/cli/command.hpp"
#include "core/explain/handbook.hpp"
#include "core/render/stage_table.hpp"

#include <iomanip>
#include <iostream>

namespace raylab::cli {

void add_stages(CLI::App& app) {
  CLI::App* command = app.add_subcommand("stages", "List the stages and their tasks");
  command->callback([] {
    for (const StageInfo& stage : stage_list()) {
      std::cout << stage.number << ' ' << stage.name << "  (" << in_handbook(std::string(stage.folder)) << ")\n";
      for (const TaskInfo& task : task_list())
        if (stage_of(task.label) == stage.number)
          std::cout << "    " << task.label << "  " << std::left << std::setw(20) << task.name << task.summary << '\n';
    }
  });
}

}  // namespace raylab::cli
