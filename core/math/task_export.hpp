#pragma once

#include <cstdint>

namespace raylab {

/// Any function; cast back to its own type before it is called.
using AnyFunction = void (*)();

/// One task as an implementation gives it out.
struct ExportedTask {
  const char* label;      ///< "5.1"
  const char* name;       ///< "reflect"
  const char* signature;  ///< the type that `function` really has, as the compiler spells it
  AnyFunction function;
};

/// All tasks of one implementation: what its one C symbol, raylab_tasks_NAME, returns.
struct ExportedTasks {
  std::uint32_t version;  ///< of the contracts: `contract_version`
  std::uint32_t count;
  const ExportedTask* tasks;
};

/// Goes up whenever a contract or one of its plain structs changes.
inline constexpr std::uint32_t contract_version = 1;

}  // namespace raylab
