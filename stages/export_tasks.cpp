// Gives an implementation's functions out under its one C symbol. Compiled into each implementation as it stands: for all
// stages or, with RAYLAB_STAGE_HEADER and RAYLAB_STAGE_TASKS, for one.

#include "core/math/task_export.hpp"
#ifdef RAYLAB_STAGE_HEADER
#include RAYLAB_STAGE_HEADER
#else
#include "stages/stages.hpp"
#define RAYLAB_STAGE_TASKS RAYLAB_TASKS
#endif

#include <iterator>
#include <typeinfo>

#define RAYLAB_JOIN_(a, b) a##b
#define RAYLAB_JOIN(a, b) RAYLAB_JOIN_(a, b)
#ifdef _WIN32
#define RAYLAB_VISIBLE __declspec(dllexport)
#else
#define RAYLAB_VISIBLE __attribute__((visibility("default")))
#endif

#ifdef RAYLAB_STAGE_HEADER
// A function that somebody's file of one stage does not define is null, and no reason to refuse the others.
namespace raylab::RAYLAB_IMPLEMENTATION {
#define RAYLAB_WEAK(label, function, summary, example) extern __attribute__((weak)) decltype(function) function;
RAYLAB_STAGE_TASKS(RAYLAB_WEAK)
#undef RAYLAB_WEAK
}  // namespace raylab::RAYLAB_IMPLEMENTATION
#endif

extern "C" RAYLAB_VISIBLE const raylab::ExportedTasks* RAYLAB_JOIN(raylab_tasks_, RAYLAB_IMPLEMENTATION)() {
  namespace implementation = raylab::RAYLAB_IMPLEMENTATION;
#define RAYLAB_ROW(label, function, summary, example)         \
  {label, #function, typeid(implementation::function).name(), \
   reinterpret_cast<raylab::AnyFunction>(&implementation::function)},
  static const raylab::ExportedTask tasks[] = {RAYLAB_STAGE_TASKS(RAYLAB_ROW)};
#undef RAYLAB_ROW
  static const raylab::ExportedTasks exported{raylab::contract_version, static_cast<std::uint32_t>(std::size(tasks)), tasks};
  return &exported;
}
