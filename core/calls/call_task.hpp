#pragma once

#include "core/calls/json_value.hpp"
#include "core/render/stage_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// What a task takes and returns, in words: "{center: [x, y, z], radius: number}"; a parameter's fields marked `?` may be
/// left out.
struct TaskSignature {
  struct Parameter {
    std::string name;
    std::string type;
  };
  std::vector<Parameter> parameters;
  std::string result;
};

TaskSignature signature_of(const TaskInfo& task);

/// The names of a task's parameters, in order.
std::vector<std::string> parameter_names(const TaskInfo& task);

struct CallAnswer {
  std::string json;  ///< one line
  bool good;         ///< is it a result?
};

/// Calls a task's function in a table, again and again.
class TaskCaller {
 public:
  TaskCaller(const StageTable& table, const TaskInfo& task);

  /// `arguments`: a JSON object with a member for each parameter, as in the task's example.
  /// Returns one line of JSON, {"task":"2.2","name":"sphere_hit","result":4.0,"hex":"0x1p+2"}: the result with decimal
  /// numbers that read back exactly, and again with hexadecimal ones. docs/call.md has the format.
  /// Throws InputError if the arguments are not what the task takes, std::runtime_error if the table has no such function,
  /// and what the function throws, as std::runtime_error where it is no std::exception.
  std::string call(std::string_view arguments) const;

  /// The result alone, JSON with decimal numbers. Throws the same.
  std::string result(std::string_view arguments) const;

  /// As call() does, where a mistake, or anything that the function throws, is an answer too: {"task":"2.2","error":"..."}.
  CallAnswer answer(std::string_view arguments) const;

  /// That answer, with the words for the mistake.
  CallAnswer mistake(std::string_view error) const;

 private:
  template <class Visit>
  void with_result(std::string_view arguments, Visit visit) const;

  StageTable table_;
  TaskInfo task_;
  std::vector<std::string> names_;  ///< of the parameters
};

}  // namespace raylab
