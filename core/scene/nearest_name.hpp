#pragma once

#include <span>
#include <string>
#include <string_view>

namespace raylab {

/// The one of `names` that `typed` was probably meant to be, by the fewest wrong, missing, extra or swapped letters;
/// empty if none is near.
std::string_view nearest_name(std::string_view typed, std::span<const std::string_view> names);

}  // namespace raylab
