#pragma once

#include "core/submission/child_process.hpp"
#include "core/submission/messages.hpp"
#include "core/submission/sandbox.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// A compiled stage, and which of its tasks count.
struct StageLibrary {
  std::filesystem::path file;
  std::vector<std::string> tasks;  ///< labels: "5.1"
};

/// What a worker may use.
struct WorkerLimits {
  std::chrono::milliseconds call{2000};              ///< of time, for a single call
  std::int64_t memory = std::int64_t{1} << 30U;      ///< bytes; without a sandbox 4 GiB
  Clock::time_point end = Clock::time_point::max();  ///< nothing is waited for any longer

  /// Of time, for all calls of a task together: ten may take as long as a call may.
  std::chrono::milliseconds all_calls() const { return 10 * call; }
};

/// What a worker runs: libraries, of which a later one wins over an earlier one. A task that is not written in a later one
/// falls back on an earlier one while images are made, not when it is called alone.
struct WorkerSetup {
  std::vector<StageLibrary> libraries;
  std::vector<std::string> environment;  ///< of the worker, "NAME=VALUE": what a sanitizer needs
  std::string with;                      ///< what `raylab call` needs to ask the same code: "--with my-lab"
  const Sandbox* sandbox = nullptr;      ///< for strangers' code; what it prints is dropped then
  WorkerLimits limits = {};
};

/// Why a task has no answer. no_value: what its process sent is no value of the task's type.
enum class Trouble { threw, crashed, too_slow, out_of_memory, no_value };

/// A call without an answer. what() says how that came, for people.
struct NoAnswer : std::runtime_error {
  NoAnswer(Trouble kind, const std::string& what) : std::runtime_error(what), trouble(kind) {}
  Trouble trouble;
  std::string label = {};      ///< of the task, if known
  std::string arguments = {};  ///< of the call, JSON, if known
};

/// A worker process: other people's code, at arm's length. It is sent plain data and sends plain data back.
class Worker {
 public:
  /// Starts it and waits until its code is loaded. Throws NoAnswer if that fails.
  explicit Worker(const WorkerSetup& setup);

  /// Sends a request and gives back its answer, JSON. `aside` is told what else it says meanwhile: a verb and the rest.
  /// limit: how long it may say nothing at all.
  /// Throws NotWritten; NoAnswer, after which this object is of no more use unless the code just `threw`; and Cancelled.
  using Aside = std::function<void(std::string_view verb, std::string_view rest)>;
  std::string ask(std::string_view request, std::chrono::milliseconds limit, const Aside& aside = {},
                  const std::atomic<bool>* cancel = nullptr);

 private:
  std::string_view reply(std::string_view line) const;

  ChildProcess process_;
  const Clock::time_point end_;
  std::uint64_t asked_ = 0;  ///< how often: the number of the last request
};

/// How somebody repeats a call: "It was asked\n  raylab call 2.2 '{...}' --with my-lab".
std::string repeated_call(const WorkerSetup& setup, std::string_view label, std::string_view arguments);

/// The compiled solution of a stage, which mixes with a student's stages.
std::filesystem::path solution_library(int stage);

}  // namespace raylab
