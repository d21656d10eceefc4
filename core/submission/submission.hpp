#pragma once

#include "core/submission/compiler.hpp"
#include "core/submission/stage_files.hpp"
#include "core/submission/worker.hpp"

#include <functional>
#include <string>
#include <vector>

namespace raylab {

/// Compiles the stages first to last of what is chosen of the submissions, where a later one wins, and gives what a worker
/// has to load: that, over the solution. stand_in: does the solution also answer for chosen tasks that are not written?
/// warnings: is told what the compiler says of files that it takes.
/// Throws DoesNotCompile, with the messages of all files, and std::runtime_error.
WorkerSetup build_submissions(const std::vector<Chosen>& submissions, int first_stage, int last_stage, bool stand_in,
                              const CompilerOptions& options, const std::function<void(const std::string&)>& warnings);

}  // namespace raylab
