#pragma once

#include "core/image/reference_file.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

/// A picture and references of it that no renderer has made: for tests of what compares them and keeps them in files.
namespace raylab::test {

inline constexpr int width = 160, height = 120;  // 19200 pixels, of which 19 may be outside

/// Smooth, with no symmetry, and far from black and white.
inline Image smooth_picture(int w = width, int h = height) {
  Image image(w, h);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const double u = static_cast<double>(x) / w, v = static_cast<double>(y) / h;
      image.at(x, y) = Color(0.2 + 0.3 * u, 0.2 + 0.4 * v * v, 0.3 + 0.2 * std::sin(5 * u + 2 * v));
    }
  return image;
}

/// Of a picture in which every pixel is certain.
inline Reference reference_of(const Image& value) {
  const std::size_t pixels = value.pixels.size();
  Reference reference{{value, value, value},
                      {},
                      std::vector<double>(pixels, 1.0),
                      std::vector<double>(pixels, 0.0),
                      std::vector<GeometryId>(pixels, no_geometry)};
  reference.scene = "scene";
  reference.stage = 5;
  reference.planes = 1;
  reference.spheres = 2;
  return reference;
}

/// `count` pixels of the picture moved by `by`, no two near one another.
inline Image with_moved(Image image, int count, double by) {
  for (int k = 0; k < count; ++k) image.at(7 * (k % 20) + 3, 7 * (k / 20) + 3) += Color(by);
  return image;
}

/// Two spheres over a plane, as objects.
inline Reference with_objects() {
  Reference reference = reference_of(smooth_picture());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      GeometryId& object = reference.object[static_cast<std::size_t>(y * width + x)];
      const auto in_disc = [&](int cx, int cy, int r) { return (x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r; };
      object = in_disc(40, 40, 20) ? 1 : in_disc(110, 60, 30) ? 2 : y > 90 ? 0 : no_geometry;
    }
  return reference;
}

}  // namespace raylab::test
