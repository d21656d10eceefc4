#include "core/submission/submission.hpp"

#include "core/render/stage_table.hpp"

#include <future>
#include <utility>

namespace raylab {
namespace {

/// A file that is being compiled.
struct Job {
  std::vector<std::string> tasks;
  std::future<StageCompiler::Built> built;
};

}  // namespace

WorkerSetup build_submissions(const std::vector<Chosen>& submissions, int first_stage, int last_stage, bool stand_in,
                              const CompilerOptions& options, const std::function<void(const std::string&)>& warnings) {
  const StageCompiler compiler(options);
  std::vector<Job> jobs;
  for (const Chosen& chosen : submissions)
    for (const auto& [stage, file] : stage_files(chosen.folder)) {
      std::vector<std::string> tasks = chosen_tasks(chosen, stage);
      if (tasks.empty() || stage < first_stage || stage > last_stage) continue;
      const auto build = [&compiler, stage = stage, file = file] { return compiler.build(stage, file); };
      jobs.push_back({std::move(tasks), std::async(std::launch::async, build)});
    }

  WorkerSetup setup;
  for (const StageInfo& stage : stage_list()) {
    std::vector<std::string> tasks = chosen_tasks({}, stage.number);
    if (!stand_in)
      for (const Job& job : jobs)
        for (const std::string& task : job.tasks) std::erase(tasks, task);
    if (!tasks.empty()) setup.libraries.push_back({solution_library(stage.number), tasks});
  }

  std::string mistakes;
  for (Job& job : jobs) try {
      StageCompiler::Built built = job.built.get();
      if (!built.warnings.empty()) warnings(built.warnings);
      setup.libraries.push_back({std::move(built.library), std::move(job.tasks)});
    } catch (const DoesNotCompile& error) {
      mistakes += error.what();
    }
  if (!mistakes.empty()) throw DoesNotCompile(mistakes);
  setup.environment = compiler.worker_environment();
  return setup;
}

}  // namespace raylab
