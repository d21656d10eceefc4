#pragma once

#include <string_view>

namespace raylab {

/// How an image file stores a component.
enum class NumberFormat { uint8, uint16, float16, float32, float64 };

/// "8 bits", "16 bits", "16-bit floats", "32-bit floats", "64-bit floats".
std::string_view name_of(NumberFormat format);

/// The greatest distance between a number near `value` (0 to 1) and the nearest one that the format holds.
double half_step(NumberFormat format, double value);

}  // namespace raylab
