#pragma once

#include "core/image/image.hpp"
#include "core/render/engine.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace raylab {

/// Takes finished rows, from the top of the image down, in the thread that called render(). `pixels` is valid during the
/// call.
using RowSink = std::function<void(int first_row, std::span<const Color> pixels)>;

/// Told now and then, at least ten times a second, which part of the image is finished: 0 to 1. In the thread that called
/// render().
using Progress = std::function<void(double done)>;

/// A pixel, from 0 at the top left.
struct PixelPlace {
  int column, row;
};

struct RenderTotals {
  RayCounts rays;
  double trace_seconds = 0;             ///< processor time of the threads in Engine::trace_rows, added up
  std::uint64_t non_finite_pixels = 0;  ///< pixels with a component that is no finite number: always a mistake somewhere
  std::optional<PixelPlace> first_non_finite;  ///< the first of these, row by row
};

/// Renders an image of `size` in bands of rows over `threads` threads (at least 1). The same pixels for any number.
/// Throws Cancelled soon after `cancel` is set, and whatever the engine, the sink or `progress` throws.
RenderTotals render(const Engine& engine, ImageSize size, unsigned threads, const RowSink& sink, const Progress& progress,
                    const std::atomic<bool>& cancel);

/// A whole image; throws as render() does. Without the last two it tells nobody and is not to be cancelled.
Image render_image(const Engine& engine, ImageSize size, unsigned threads, const Progress& progress,
                   const std::atomic<bool>& cancel);
Image render_image(const Engine& engine, ImageSize size, unsigned threads);

}  // namespace raylab
