#pragma once

#include "core/math/vec3.hpp"

#include <cstddef>
#include <vector>

namespace raylab {

/// A whole image in memory: rows from the top, each from the left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Color> pixels;

  Image() = default;
  Image(int w, int h, const Color& fill = Color(0))
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

  Color& at(int column, int row) { return pixels[index(column, row)]; }
  const Color& at(int column, int row) const { return pixels[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

}  // namespace raylab
