#include "core/image/diff_pictures.hpp"

#include "core/image/label.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace raylab {
namespace {

constexpr int levels = 256;
constexpr double decades = 4;
constexpr int panel_size = 320;
constexpr int gap = 12;
constexpr int label_scale = 2;
constexpr int label_height = label_row * label_scale + 6;
const Color paper(0.11);
const Color ink(0.92);

/// Copies `image` to (column, row), each pixel `scale` pixels wide.
void paste(Image& page, const Image& image, int column, int row, int scale) {
  for (int y = 0; y < image.height * scale; ++y)
    for (int x = 0; x < image.width * scale; ++x) page.at(column + x, row + y) = image.at(x / scale, y / scale);
}

}  // namespace

std::vector<Color> heat_colors() {
  std::array<float, levels> ramp{};
  for (std::size_t k = 0; k < ramp.size(); ++k) ramp[k] = static_cast<float>(k) / (levels - 1);
  const OIIO::ImageBuf source(OIIO::ImageSpec(levels, 1, 1, OIIO::TypeDesc::FLOAT), ramp.data());
  const OIIO::ImageBuf mapped = OIIO::ImageBufAlgo::color_map(source, 0, "inferno");
  std::vector<Color> colors;
  for (int k = 0; k < levels; ++k) {
    std::array<float, 3> rgb{};
    mapped.getpixel(k, 0, rgb.data(), 3);
    colors.emplace_back(rgb[0], rgb[1], rgb[2]);
  }
  return colors;
}

double heat_level(double error) { return error > 0 ? std::clamp(1 + std::log10(error) / decades, 0.0, 1.0) : 0.0; }

Image heat_map(const Comparison& comparison) {
  const std::vector<Color> colors = heat_colors();
  Image map(comparison.width, comparison.height);
  for (std::size_t k = 0; k < map.pixels.size(); ++k) {
    const double error = comparison.error[k];
    map.pixels[k] =
        std::isfinite(error) ? colors[static_cast<std::size_t>(heat_level(error) * (levels - 1) + 0.5)] : non_finite_color;
  }
  return map;
}

Image in_a_row(const std::vector<Panel>& panels) {
  const Image& first = panels.front().image;
  const int scale = std::max(1, panel_size / std::max(first.width, first.height));
  const int across = first.width * scale + gap;
  Image page(gap + static_cast<int>(panels.size()) * across, gap + label_height + first.height * scale + gap, paper);
  int column = gap;
  for (const auto& [label, image] : panels) {
    draw_label(page, column, gap, label, ink, label_scale);
    paste(page, image, column, gap + label_height, scale);
    column += across;
  }
  return page;
}

Image side_by_side(const Image& image, const Reference& reference, const Comparison& comparison) {
  const Image& value = comparison.clamped_each ? reference.each->value : reference.value;
  return in_a_row({{"image", image}, {"reference", value}, {"error 1e-4 to 1", heat_map(comparison)}});
}

}  // namespace raylab
