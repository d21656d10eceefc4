#pragma once

#include "core/image/reference.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raylab {

/// What became of a pixel in a comparison.
enum class PixelVerdict : std::uint8_t {
  within,       ///< in its range
  at_decision,  ///< beyond its range, but rounding may decide this pixel either way (hit or miss, lit or not): not counted
  outside,      ///< beyond its range, or not a finite number
};

/// A pixel that is outside its range.
struct OutsidePixel {
  int column, row;  ///< from the top left, from 0
  Color image, least, greatest;
  double distance;  ///< how far beyond, in the worst channel; infinite if a component is not finite
};

/// A statement about what the whole difference looks like, computed and not guessed.
struct Finding {
  std::string kind;  ///< for programs: "mirrored", "one-object", ...
  std::string text;  ///< for people, one sentence
};

/// The numbers of the policy. docs/tolerance.md says what they were measured from.
struct Tolerance {
  double gain;          ///< of a pixel's sensitivity: what rounding in a float renderer moves it by
  double floor;         ///< what rounding moves even a pixel of no sensitivity by
  double near_margin;   ///< up to this margin a decision is near
  double outside;       ///< the share of all pixels that may be outside ...
  std::size_t densest;  ///< ... and how many in any square of 5 x 5 pixels
};
inline constexpr Tolerance calibrated{64 * 0x1p29, 64 * 0x1p-24, 3e-3, 1e-3, 6};

/// How an image compares with a reference. docs/tolerance.md explains the policy.
struct Comparison {
  int width = 0, height = 0;
  bool same = false;
  bool knows_decisions = false;  ///< does the reference say where they are?
  bool clamped_each = false;     ///< compared with the variant that clamps each dot product by itself, which fits better
  double score = 0;  ///< the greatest of outside/allowed and densest/densest_allowed: same up to 1; infinite if not finite

  std::size_t outside = 0;          ///< pixels outside their range
  std::size_t allowed = 0;          ///< how many may be
  std::size_t densest = 0;          ///< the most of them in any square of 5 x 5 pixels
  std::size_t densest_allowed = 0;  ///< how many may be
  std::size_t at_decision = 0;      ///< pixels beyond their range that do not count, since rounding decides them
  std::size_t non_finite = 0;       ///< pixels with a component that is not a finite number

  // Image against reference value, over the components of all finite pixels; not numbers if there are none.
  double max_error = 0;
  double mean_error = 0;
  double rmse = 0;
  double psnr = 0;                ///< decibels, of a peak of 1; infinite for equal images
  double share_at_decisions = 0;  ///< of the squared error, the part in pixels with a decision near; the rest is smooth

  std::vector<OutsidePixel> worst;  ///< the ten farthest beyond their range
  std::vector<Finding> findings;

  // For pictures: one for each pixel.
  std::vector<PixelVerdict> verdict;
  std::vector<double> error;  ///< the largest |image - reference| of the channels; infinite where not finite
};

/// Compares an image, read from a file of the given format, with a reference of the same size; with either way to clamp, and
/// the better counts. An image whose numbers are all whole 255ths is taken as one of 8 bits. `findings` stay empty: see
/// find_patterns().
Comparison compare(const Image& image, NumberFormat format, const Reference& reference);

}  // namespace raylab
