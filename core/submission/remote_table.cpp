#include "core/submission/remote_table.hpp"

#include "core/calls/call_function.hpp"
#include "core/calls/call_task.hpp"
#include "core/calls/routed_table.hpp"

#include <stdexcept>
#include <utility>

namespace raylab {
namespace {

RemoteTable* newest = nullptr;

struct ToWorker {
  static ToWorker& current() {
    static ToWorker one;
    return one;
  }

  template <auto member, class... Parameters>
  auto call(const TaskInfo& task, const Parameters&... arguments) {
    static const std::vector<std::string> names = parameter_names(task);
    if (!newest) throw std::logic_error("the submission of this table is gone");
    return from_json<ResultOf<member>>(newest->ask(task, arguments_json(names, arguments...)));
  }
};

std::string title(const TaskInfo& task) { return "task " + std::string(task.label) + " " + std::string(task.name); }

}  // namespace

RemoteTable::RemoteTable(WorkerSetup setup) : setup_(std::move(setup)) { newest = this; }

RemoteTable::~RemoteTable() {
  if (newest == this) newest = nullptr;
}

StageTable RemoteTable::table() const { return routed_table<ToWorker>(); }

std::string RemoteTable::ask(const TaskInfo& task, const std::string& arguments) {
  int& losses = losses_[static_cast<std::size_t>(&task_info(task.label) - task_list().data())];
  if (losses == most_losses)
    throw std::runtime_error(title(task) + " is not asked any more: it has ended its process " +
                             std::to_string(most_losses) + " times");
  if (!worker_) worker_ = std::make_unique<Worker>(setup_);
  try {
    return worker_->ask("call " + std::string(task.label) + ' ' + arguments, limit);
  } catch (const ChildEnded& error) {
    ++losses;
    worker_.reset();
    throw std::runtime_error(title(task) + ' ' + error.what() + ". " + repeated_call(setup_, task.label, arguments));
  } catch (const ChildSilent& error) {
    ++losses;
    worker_.reset();
    throw std::runtime_error(title(task) + ' ' + error.what() + ". " + repeated_call(setup_, task.label, arguments));
  }
}

}  // namespace raylab
