#include "core/submission/remote_table.hpp"

#include "core/calls/call_function.hpp"
#include "core/calls/call_task.hpp"
#include "core/calls/routed_table.hpp"
#include "core/scene/diagnostic.hpp"

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
  ResultOf<member> call(const TaskInfo& task, const Parameters&... arguments) {
    static const std::vector<std::string> names = parameter_names(task);
    if (!newest) throw std::logic_error("the submission of this table is gone");
    const std::string asked = arguments_json(names, arguments...);
    return from_json<ResultOf<member>>(newest->ask(task, asked));
  }
};

/// Throws NoAnswer unless it is a value of what the task gives.
void require_value(const TaskInfo& task, const std::string& answer) {
  try {
#define RAYLAB_READ(title, function, summary, example) \
  if (task.label == title) from_json<ResultOf<&StageTable::function>>(answer);
    RAYLAB_TASKS(RAYLAB_READ)
#undef RAYLAB_READ
  } catch (const InputError& error) {
    throw NoAnswer(Trouble::no_value, "gave an answer that is none: " + printable(error.what()));
  }
}

std::size_t index_of(const TaskInfo& task) { return static_cast<std::size_t>(&task_info(task.label) - task_list().data()); }

std::string title(const TaskInfo& task) { return "task " + std::string(task.label) + " " + std::string(task.name); }

}  // namespace

RemoteTable::RemoteTable(WorkerSetup setup, CallListener listener)
    : setup_(std::move(setup)), listener_(std::move(listener)) {
  newest = this;
}

RemoteTable::~RemoteTable() {
  if (newest == this) newest = nullptr;
}

StageTable RemoteTable::table() const { return routed_table<ToWorker>(); }

std::string RemoteTable::ask(const TaskInfo& task, const std::string& arguments) {
  int& losses = losses_[index_of(task)];
  if (losses == most_losses)
    throw std::runtime_error(title(task) + " is not asked any more: it has ended its process " +
                             std::to_string(most_losses) + " times");
  try {
    if (!worker_) worker_ = std::make_unique<Worker>(setup_);
  } catch (NoAnswer& error) {
    ++losses;
    error.label = task.label;
    if (listener_.failed) listener_.failed(error);
    throw;
  }
  const auto start = Clock::now();
  try {
    std::string answer = worker_->ask("call " + std::string(task.label) + ' ' + arguments, setup_.limits.call);
    require_value(task, answer);
    if (listener_.answered) listener_.answered(task, arguments, answer);
    Clock::duration& spent = spent_[index_of(task)];
    spent += Clock::now() - start;
    if (spent > setup_.limits.all_calls()) throw NoAnswer(Trouble::too_slow, "takes too long over its calls, all together");
    return answer;
  } catch (const NoAnswer& error) {
    if (error.trouble != Trouble::threw) {
      ++losses;
      worker_.reset();
    }
    fail(task, arguments, error);
  }
}

void RemoteTable::forget() { worker_.reset(); }

void RemoteTable::fail(const TaskInfo& task, const std::string& arguments, const NoAnswer& error) {
  NoAnswer full(error.trouble, title(task) + ' ' + error.what() + ". " + repeated_call(setup_, task.label, arguments));
  full.label = task.label;
  full.arguments = arguments;
  if (listener_.failed) listener_.failed(full);
  throw full;
}

}  // namespace raylab
