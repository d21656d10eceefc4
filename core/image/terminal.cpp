#include "core/image/terminal.hpp"

#include "core/image/image_file.hpp"

#include <OpenImageIO/sysutil.h>

#include <algorithm>
#include <cstdio>

namespace raylab {

bool error_is_terminal() { return OIIO::Sysutil::Term(stderr).is_console(); }

int terminal_columns() { return OIIO::Sysutil::terminal_columns(); }

std::size_t memory_in_use() { return OIIO::Sysutil::memory_used(true); }

Preview::Preview(int width, int height, int columns, int rows) : width_(width), height_(height) {
  const double scale = std::min({1.0, static_cast<double>(columns) / width, static_cast<double>(rows) / height});
  sum_ = Image(std::max(1, static_cast<int>(width * scale)), std::max(1, static_cast<int>(height * scale)));
  samples_.resize(sum_.pixels.size());
}

void Preview::add_rows(int first_row, std::span<const Color> pixels) {
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const auto column = static_cast<long long>(k % static_cast<std::size_t>(width_));
    const auto row = first_row + static_cast<long long>(k / static_cast<std::size_t>(width_));
    const auto x = static_cast<int>(column * sum_.width / width_);
    const auto y = static_cast<int>(row * sum_.height / height_);
    sum_.at(x, y) += pixels[k];
    ++samples_[static_cast<std::size_t>(&sum_.at(x, y) - sum_.pixels.data())];
  }
}

std::string Preview::half_blocks() const {
  const auto paint = [&](const char* layer, int x, int y) {
    const auto k = static_cast<std::size_t>(y * sum_.width + x);
    const Color mean = sum_.pixels[k] / static_cast<double>(std::max(1u, samples_[k]));
    return std::string("\x1b[") + layer + ";2;" + std::to_string(quantise(mean.r)) + ";" + std::to_string(quantise(mean.g)) +
           ";" + std::to_string(quantise(mean.b)) + "m";
  };
  std::string text;
  for (int y = 0; y < sum_.height; y += 2) {
    for (int x = 0; x < sum_.width; ++x) {
      text += paint("38", x, y);
      if (y + 1 < sum_.height) text += paint("48", x, y + 1);
      text += "\u2580";  // upper half block
    }
    text += "\x1b[0m\n";
  }
  return text;
}

}  // namespace raylab
