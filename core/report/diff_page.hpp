#pragma once

#include "core/image/diff.hpp"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace raylab {

/// What the page of a comparison shows. Whatever the members refer to must outlive it.
struct DiffPage {
  std::string title;  ///< these three are any text: bytes that are not UTF-8 are shown as replacement characters
  std::string image_name;
  std::string reference_name;
  const Image& image;
  const Reference& reference;    ///< of the image's size, with the ranges compared with: those of `each` if clamped_each
  const Comparison& comparison;  ///< of these two
  std::vector<Color> color_map;  ///< the heat map's 256 colors, from the least error to the greatest
};

/// The most pixels that a page holds: its file takes about 55 bytes for each.
inline constexpr std::size_t largest_page = 4'000'000;

/// Writes an HTML page that shows where and how an image differs from a reference, with every pixel's numbers in it: one
/// file that needs no other, nor a network. The numbers are rounded to floats. Throws std::runtime_error, before it writes
/// anything, if the image has more pixels than `largest_page`.
void write_diff_page(std::ostream& out, const DiffPage& page);

}  // namespace raylab
