#pragma once

#include "core/image/image.hpp"
#include "core/image/number_format.hpp"
#include "core/math/ray.hpp"

#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// What the pixels of an image may be: the model's value, and the least and greatest that accepted variants give
/// (docs/model.md, "Accepted variants").
struct PixelRanges {
  Image value, least, greatest;  ///< clamped to 0..1
};

/// An image to compare with, and what is known about each of its pixels. All vectors are as long as the image, in its order.
struct Reference : PixelRanges {
  std::optional<PixelRanges> each;  ///< with each dot product clamped by itself, an accepted variant, where that differs
  std::vector<double> margin;       ///< the least slack of any decision on the pixel's ray tree, 0 to 1; 1 where not known
  std::vector<double>
      sensitivity;                 ///< how far the pixel moves when each of its rays is rounded to double; 0 where not known
  std::vector<GeometryId> object;  ///< what the pixel's centre shows; no_geometry for background, or where not known
  NumberFormat format = NumberFormat::float32;  ///< in which the values are stored

  std::string scene = {};  ///< "scene3"; empty for an image that does not say
  int stage = 0;           ///< 0 where not known
  int planes = 0;          ///< of the scene: with `spheres` they name an object by its number
  int spheres = 0;

  /// Is it one of raylab's own, whose margin, sensitivity and object say something?
  bool has_word() const { return stage != 0; }
};

}  // namespace raylab
