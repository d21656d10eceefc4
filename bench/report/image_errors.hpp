#pragma once

#include "bench/report/unit.hpp"
#include "core/image/image.hpp"

namespace raylab::bench {

/// A pixel with a component that is off by more than this is flipped: not rounded differently, but decided differently. Two
/// of the 255 steps of an image.
inline constexpr double flipped_by = 2. / 255;

/// The part of the pixels that may be flipped in an image that is right: docs/tolerance.md.
inline constexpr double most_flipped = 1e-3;

/// How an image differs from the right one, of the same size: {"rmse", "max", "psnr", "flipped", "non_finite", "pixels",
/// "rmse_rest", "max_rest", "rmse_judged"}. Errors are of color components, 1 being white; `psnr` in decibels, null where
/// there is no error;
/// *_rest are over the pixels that are not flipped. `rmse_judged` is rmse_rest as long as no more pixels are flipped than
/// `raylab diff` lets pass, one in a thousand, else rmse: what to compare variants by. Pixels that are not finite count as
/// such and nowhere else; where `right` is not finite, the pixel is left out.
Json image_error(const Image& image, const Image& right);

}  // namespace raylab::bench
