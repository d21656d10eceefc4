#pragma once

#include "core/submission/worker.hpp"

#include "core/render/stage_table.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>

namespace raylab {

/// What somebody may want to know of a RemoteTable's calls.
struct CallListener {
  std::function<void(const TaskInfo& task, const std::string& arguments, const std::string& answer)> answered = {};
  std::function<void(const NoAnswer&)> failed = {};  ///< before that is thrown
};

/// The tasks of a submission as a table: each call is a question to a worker, one at a time. A call that ends the worker, or
/// takes longer than the setup allows, throws NoAnswer, whose text says which call that was; the next one has a new worker.
/// After three in one task its other calls fail at once.
class RemoteTable {
 public:
  explicit RemoteTable(WorkerSetup setup, CallListener listener = {});
  ~RemoteTable();
  RemoteTable(const RemoteTable&) = delete;
  RemoteTable& operator=(const RemoteTable&) = delete;

  /// Only the newest RemoteTable answers.
  StageTable table() const;

  /// The answer to a call, JSON: a value of what the task gives. Anything else ends the worker too.
  std::string ask(const TaskInfo& task, const std::string& arguments);

  /// The next call has a new worker, which cannot know what was asked before.
  void forget();

 private:
  [[noreturn]] void fail(const TaskInfo& task, const std::string& arguments, const NoAnswer& error);

  static constexpr int most_losses = 3;

  WorkerSetup setup_;
  CallListener listener_;
  std::unique_ptr<Worker> worker_;
  std::array<int, static_cast<std::size_t>(TaskIndex::count)> losses_{};
  std::array<Clock::duration, static_cast<std::size_t>(TaskIndex::count)> spent_{};
};

}  // namespace raylab
