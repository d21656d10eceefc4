// Gives an implementation's functions out under its one C symbol. Compiled into each implementation as it stands.

#include "core/math/task_export.hpp"
#include "stages/stages.hpp"

#include <iterator>
#include <typeinfo>

#define RAYLAB_JOIN_(a, b) a##b
#define RAYLAB_JOIN(a, b) RAYLAB_JOIN_(a, b)
#ifdef _WIN32
#define RAYLAB_VISIBLE __declspec(dllexport)
#else
#define RAYLAB_VISIBLE __attribute__((visibility("default")))
#endif

extern "C" RAYLAB_VISIBLE const raylab::ExportedTasks* RAYLAB_JOIN(raylab_tasks_, RAYLAB_IMPLEMENTATION)() {
  namespace implementation = raylab::RAYLAB_IMPLEMENTATION;
#define RAYLAB_ROW(label, function, summary, example)         \
  {label, #function, typeid(implementation::function).name(), \
   reinterpret_cast<raylab::AnyFunction>(&implementation::function)},
  static const raylab::ExportedTask tasks[] = {RAYLAB_TASKS(RAYLAB_ROW)};
#undef RAYLAB_ROW
  static const raylab::ExportedTasks exported{raylab::contract_version, static_cast<std::uint32_t>(std::size(tasks)), tasks};
  return &exported;
}
