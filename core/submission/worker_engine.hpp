#pragma once

#include "core/render/engine.hpp"
#include "core/submission/worker.hpp"

#include <functional>
#include <memory>
#include <string>

namespace raylab {

/// Images by a submission: the driver runs in worker processes, one a thread, beside the tasks that it asks. When a worker
/// is lost, the same few pixels are traced again with each call announced, so that trace_rows() can say in which call it
/// was. stands_in: is told once of each task that is not written, and that the solution's stands in for.
std::unique_ptr<Engine> make_worker_engine(const Scene& scene, const Settings& settings, const WorkerSetup& setup,
                                           unsigned threads, std::function<void(const std::string&)> stands_in);

}  // namespace raylab
