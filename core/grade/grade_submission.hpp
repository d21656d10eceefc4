#pragma once

#include "core/explain/first_difference.hpp"
#include "core/grade/grading.hpp"
#include "core/grade/view.hpp"
#include "core/render/stage_table.hpp"
#include "core/results/results.hpp"
#include "core/submission/sandbox.hpp"
#include "core/submission/taken_files.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// How students name their submission in the commands that reports show.
inline constexpr const char* with_submission = "--with YOUR-FOLDER";

/// What a task's unit tests say of a table.
struct TestOutcome {
  int passed = 0;
  std::vector<FailedTest> failed;
};

/// What is known of a task that answers wrongly.
struct WrongTask {
  std::string hint;     ///< up to the level asked for
  std::string mistake;  ///< the known mistake that answers alike; empty if there is none
};

/// What grading takes from the program around it.
struct GradingTools {
  const Sandbox& sandbox;
  StageTable solution;
  std::function<TestOutcome(std::string_view task, const StageTable&)> run_tests;
  std::function<WrongTask(std::string_view task, const AskTask&, int level)> look_at;
};

/// Grades what was taken of a submission, stage by stage, each over the solution's other stages. Images are written to
/// `folder`. Of the result, `id` and `inputs` are left to the caller. The submission's code runs in the sandbox alone, and
/// whatever it does becomes a verdict; throws std::runtime_error for what goes wrong on this side.
SubmissionResult grade_submission(const TakenFiles& files, const Grading& grading, const std::vector<View>& views,
                                  const GradingTools& tools, const std::filesystem::path& folder);

/// The result of a submission that could not be graded: nothing but `infrastructure`, and why.
SubmissionResult not_graded(const Grading& grading, const std::string& why);

}  // namespace raylab
