#pragma once

#include "core/submission/worker.hpp"

#include "core/render/stage_table.hpp"

#include <array>
#include <memory>
#include <string>

namespace raylab {

/// The tasks of a submission as a table: each call is a question to a worker, one at a time. A call that ends the worker, or
/// takes longer than `limit`, throws std::runtime_error, whose text says which call that was; the next one has a new worker.
/// After three in one task its other calls fail at once.
class RemoteTable {
 public:
  explicit RemoteTable(WorkerSetup setup);
  ~RemoteTable();
  RemoteTable(const RemoteTable&) = delete;
  RemoteTable& operator=(const RemoteTable&) = delete;

  /// Only the newest RemoteTable answers.
  StageTable table() const;

  /// The answer to a call, JSON.
  std::string ask(const TaskInfo& task, const std::string& arguments);

 private:
  static constexpr std::chrono::milliseconds limit{2000};
  static constexpr int most_losses = 3;

  WorkerSetup setup_;
  std::unique_ptr<Worker> worker_;
  std::array<int, static_cast<std::size_t>(TaskIndex::count)> losses_{};
};

}  // namespace raylab
