#pragma once

#include <stdexcept>
#include <string>

/// The namespace of the functions that a stage.hpp declares, inside `raylab`. Each implementation's target defines its own
/// (`solution`, `starter`, ...), so that several live in one program. Code that only needs to know the functions' types
/// sees them in `contract`, where nothing defines them.
#ifndef RAYLAB_IMPLEMENTATION
#define RAYLAB_IMPLEMENTATION contract
#endif

namespace raylab {

/// Thrown by a starter's function until it is written; what() is "task 5.1 is not written yet: FILE:LINE".
struct NotWritten : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace raylab

/// Stands in a starter for the code to write: says which task is missing, and where.
#define RAYLAB_NOT_WRITTEN(label) \
  throw ::raylab::NotWritten(std::string("task " label " is not written yet: " __FILE__ ":") + std::to_string(__LINE__))
