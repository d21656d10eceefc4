#pragma once

#include "core/render/stage_table.hpp"

#include <cstddef>

namespace raylab {

/// One function of a routed table.
template <class Router, auto member, std::size_t index, class Function>
struct Route;
template <class Router, auto member, std::size_t index, class Result, class... Parameters>
struct Route<Router, member, index, Result (*)(Parameters...)> {
  static Result call(Parameters... arguments) {
    return Router::current().template call<member>(task_list()[index], arguments...);
  }
};

/// A table whose functions all hand their calls to one object, since a plain function pointer can carry none: a recorder,
/// say, or the way to another process. `Router` has
///
///     static Router& current();
///     template <auto member, class... Parameters>                           // member: the task's place in a StageTable
///     auto call(const TaskInfo& task, const Parameters&... arguments);      // gives the task's result
template <class Router>
StageTable routed_table() {
  StageTable table;
#define RAYLAB_ROUTE(label, function, summary, example)                                                \
  table.function = Route<Router, &StageTable::function, static_cast<std::size_t>(TaskIndex::function), \
                         decltype(StageTable::function)>::call;
  RAYLAB_TASKS(RAYLAB_ROUTE)
#undef RAYLAB_ROUTE
  return table;
}

/// What the task at `member` of a StageTable returns.
template <class Function>
struct ReturnOf;
template <class Result, class... Parameters>
struct ReturnOf<Result (*StageTable::*)(Parameters...)> {
  using Type = Result;
};
template <auto member>
using ResultOf = typename ReturnOf<decltype(member)>::Type;

}  // namespace raylab
