#include "core/calls/call_task.hpp"

#include "core/calls/call_function.hpp"

#include <exception>
#include <stdexcept>

namespace raylab {
namespace {

/// Calls `visit` with the function of the task with that label.
template <class Visit>
void with_function(const StageTable& table, std::string_view task, Visit visit) {
#define RAYLAB_VISIT(label, function, summary, example) \
  if (task == label) visit(table.function);
  RAYLAB_TASKS(RAYLAB_VISIT)
#undef RAYLAB_VISIT
}

/// The keys of a task's example, which name its parameters; nothing else does.
std::vector<std::string> example_keys(const TaskInfo& task, std::size_t count) {
  const JsonValue example = parse_json(task.example);
  std::vector<std::string> names;
  for (const JsonMember& argument : std::get<JsonObject>(example.data)) names.push_back(argument.key);
  if (names.size() != count)
    throw std::logic_error("the example of task " + std::string(task.label) + " has " + std::to_string(names.size()) +
                           " arguments, and its function takes " + std::to_string(count));
  return names;
}

template <class Result, class... Parameters>
TaskSignature signature(const TaskInfo& task, Result (*)(Parameters...)) {
  const std::vector<std::string> names = example_keys(task, sizeof...(Parameters));
  [[maybe_unused]] auto name = names.begin();
  std::string result = PlainJson<Result>::describe();
  std::erase(result, '?');  // a result has all its fields
  return {{{*name++, PlainJson<typename Kept<Parameters>::Type>::describe()}...}, result};
}

}  // namespace

TaskSignature signature_of(const TaskInfo& task) {
  TaskSignature found;
  with_function({}, task.label, [&](auto function) { found = signature(task, function); });
  return found;
}

std::vector<std::string> parameter_names(const TaskInfo& task) {
  std::vector<std::string> names;
  with_function({}, task.label, [&]<class Result, class... Parameters>(Result (*)(Parameters...)) {
    names = example_keys(task, sizeof...(Parameters));
  });
  return names;
}

TaskCaller::TaskCaller(const StageTable& table, const TaskInfo& task)
    : table_(table), task_(task), names_(parameter_names(task)) {}

/// Calls visit(result) with what the function gives.
template <class Visit>
void TaskCaller::with_result(std::string_view arguments, Visit visit) const {
  const auto call = [&]<class Result, class... Parameters>(Result (*function)(Parameters...)) {
    if (!function) throw std::runtime_error("task " + std::string(task_.label) + " is not in this implementation");
    visit(call_function(function, names_, parse_json(arguments)));
  };
  try {
    with_function(table_, task_.label, call);
  } catch (const std::exception&) {
    throw;
  } catch (...) {
    throw std::runtime_error("the function threw something that is no std::exception");
  }
}

std::string TaskCaller::call(std::string_view arguments) const {
  std::string line = "{\"task\":" + json_string(task_.label) + ",\"name\":" + json_string(task_.name) + ",\"result\":";
  with_result(arguments, [&]<class Result>(const Result& result) {
    PlainJson<Result>::write(line, result, json_number);
    line += ",\"hex\":";
    PlainJson<Result>::write(line, result, json_hex_number);
  });
  return line + '}';
}

std::string TaskCaller::result(std::string_view arguments) const {
  std::string text;
  with_result(arguments, [&]<class Result>(const Result& result) { PlainJson<Result>::write(text, result, json_number); });
  return text;
}

CallAnswer TaskCaller::answer(std::string_view arguments) const {
  try {
    return {call(arguments), true};
  } catch (const std::exception& error) {
    return mistake(error.what());
  }
}

CallAnswer TaskCaller::mistake(std::string_view error) const {
  return {"{\"task\":" + json_string(task_.label) + ",\"error\":" + json_string(error) + '}', false};
}

}  // namespace raylab
