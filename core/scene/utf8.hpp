#pragma once

#include <cstddef>
#include <string_view>

namespace raylab {

/// How many bytes the character at the start of `text` has, 1 to 4; 0 if no UTF-8 character stands there.
std::size_t utf8_length(std::string_view text);

}  // namespace raylab
