#pragma once

#include "core/image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace raylab {

/// Does standard error go to a terminal, where a progress bar can be redrawn?
bool error_is_terminal();

/// Columns of the terminal; 80 where there is none.
int terminal_columns();

/// Bytes of memory that this process holds now.
std::size_t memory_in_use();

/// A small copy of an image that arrives in bands of rows: each of its pixels is the mean of a block.
class Preview {
 public:
  /// At most `columns` x `rows` pixels, in the proportions of the image.
  Preview(int width, int height, int columns, int rows);

  void add_rows(int first_row, std::span<const Color> pixels);

  /// The copy as text for a terminal of 24-bit color: each character shows two pixels, one above the other. Ends in a
  /// line break.
  std::string half_blocks() const;

 private:
  int width_, height_;
  Image sum_;
  std::vector<std::uint32_t> samples_;
};

}  // namespace raylab
