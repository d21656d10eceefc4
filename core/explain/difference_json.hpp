#pragma once

#include "core/explain/first_difference.hpp"

#include <nlohmann/json.hpp>

namespace raylab {

/// A difference for programs: task, name, arguments, expected, formula, handout, and got or error.
nlohmann::ordered_json difference_json(const Difference& difference);

}  // namespace raylab
