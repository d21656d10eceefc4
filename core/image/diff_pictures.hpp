#pragma once

#include "core/image/diff.hpp"

#include <string_view>
#include <vector>

namespace raylab {

/// 256 colors from dark to bright, from no error to the largest, that people with any kind of color vision can tell apart.
std::vector<Color> heat_colors();

/// Where an error of 0 to 1 stands on the color map, from 0 to 1: logarithmic, an error of 1e-4 and below at its start.
double heat_level(double error);

/// The errors of a comparison as a picture of the image's size in heat_colors(); pixels that are not finite are a color that
/// does not occur there, non_finite_color.
Image heat_map(const Comparison& comparison);
inline const Color non_finite_color(0.0, 1.0, 1.0);

/// An image with its label, for as long as both live.
struct Panel {
  std::string_view label;
  const Image& image;
};

/// Images of one size beside one another, small ones enlarged by a whole factor, with their labels above.
Image in_a_row(const std::vector<Panel>& panels);

/// Image, reference and heat map beside one another, small ones enlarged by a whole factor, with labels.
Image side_by_side(const Image& image, const Reference& reference, const Comparison& comparison);

}  // namespace raylab
