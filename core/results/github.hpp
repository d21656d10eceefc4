#pragma once

#include "core/results/results.hpp"

#include <string>

namespace raylab {

/// A submission's results for a GitHub step summary, as its student may see them: a table of the stages, and what is wrong
/// in folds. Whatever a submission wrote stands there as text: no HTML, Markdown, mention or workflow command of it gets
/// through. Stays below the size that GitHub takes.
std::string github_summary(const SubmissionResult& submission);

/// The same results as workflow commands for standard output, a line each: GitHub shows them beside the files' lines. An
/// error for each compiler error and each task that failed, a warning for what is not written or raylab failed to judge.
std::string github_annotations(const SubmissionResult& submission);

}  // namespace raylab
