#include "core/scene/read_decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>

namespace raylab {
namespace {

/// The exponent that is written behind the `e`, cut to what an int holds.
int written_exponent(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  if (e == std::string_view::npos) return 0;
  text.remove_prefix(e + 1);
  if (text.front() == '+') text.remove_prefix(1);
  int exponent = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (result.ec == std::errc{}) return exponent;
  constexpr int huge = 2'000'000'000;
  return text.front() == '-' ? -huge : huge;
}

/// Is this number, one beyond the range of doubles, beyond its lower end? Only its size in powers of ten matters.
bool is_tiny(std::string_view text) {
  const std::string_view digits = text.substr(0, text.find_first_of("eE"));
  const auto point = static_cast<double>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<double>(std::min(digits.find_first_of("123456789"), digits.size()));
  return point - first + written_exponent(text) < 0;
}

}  // namespace

std::optional<double> parse_decimal(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc{}) return number;
  // from_chars says only "out of range" at either end, and which double to take there it leaves open.
  const double size = is_tiny(text) ? 0.0 : std::numeric_limits<double>::infinity();
  return text.front() == '-' ? -size : size;
}

}  // namespace raylab
