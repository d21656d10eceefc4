#pragma once

#include "core/image/image.hpp"

#include <string_view>

namespace raylab {

/// Columns and rows of pixels that one character of a label takes at scale 1, with the gap to the next.
inline constexpr int label_column = 6;
inline constexpr int label_row = 9;

/// Writes one line of text into an image, its top left corner at (column, row), each dot `scale` pixels wide. Printable
/// ASCII; other characters show as '?'. What lies outside the image is cut off.
void draw_label(Image& image, int column, int row, std::string_view text, const Color& color, int scale);

}  // namespace raylab
