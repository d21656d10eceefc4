#pragma once

#include "core/image/diff.hpp"

#include <nlohmann/json.hpp>

namespace raylab {

/// A comparison as JSON, but for what is kept of each pixel. What JSON has no numbers for is text: "NaN", "Infinity",
/// "-Infinity", which JavaScript's Number() and Python's float() read.
nlohmann::ordered_json comparison_json(const Comparison& comparison);

}  // namespace raylab
