#include "core/image/number_format.hpp"

#include <algorithm>
#include <cmath>

namespace raylab {
namespace {

/// Half a unit in the last place of a binary floating-point format, subnormal numbers included.
double half_unit(double value, int significant_bits, int least_exponent) {
  if (value == 0) return std::ldexp(0.5, least_exponent);
  int exponent = 0;  // value is below 2^exponent, and not below half of that
  std::frexp(value, &exponent);
  return std::ldexp(0.5, std::max(exponent - significant_bits, least_exponent));
}

}  // namespace

std::string_view name_of(NumberFormat format) {
  switch (format) {
    case NumberFormat::uint8:
      return "8 bits";
    case NumberFormat::uint16:
      return "16 bits";
    case NumberFormat::float16:
      return "16-bit floats";
    case NumberFormat::float32:
      return "32-bit floats";
    case NumberFormat::float64:
      break;
  }
  return "64-bit floats";
}

double half_step(NumberFormat format, double value) {
  switch (format) {
    case NumberFormat::uint8:
      return 0.5 / 255;
    case NumberFormat::uint16:
      return 0.5 / 65535;
    case NumberFormat::float16:
      return half_unit(value, 11, -24);
    case NumberFormat::float32:
      return half_unit(value, 24, -149);
    case NumberFormat::float64:
      break;
  }
  return half_unit(value, 53, -1074);
}

}  // namespace raylab
