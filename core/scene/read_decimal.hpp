#pragma once

#include <optional>
#include <string_view>

namespace raylab {

/// The double nearest to a decimal number such as `-1.5e-3`, whatever the locale: 0 for 1e-400, infinity for 1e400.
/// `inf` and `nan` are numbers too. Nothing if the whole of `text` is not a number.
std::optional<double> parse_decimal(std::string_view text);

}  // namespace raylab
