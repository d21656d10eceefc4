#pragma once

#include "core/render/render.hpp"

#include <string>

namespace raylab::cli {

/// Makes Ctrl-C (and a request to end) set the flag that this returns, from the first call on; a second one ends at once.
const std::atomic<bool>& interrupt_flag();

/// render() as a user at a terminal wants it: with a progress bar that says what is rendered and the remaining time, once it
/// takes longer than a second, and a warning if there are pixels that are no numbers. Throws Cancelled on Ctrl-C.
/// threads: 0 for as many as there are cores. `tick` is called at every report of progress.
RenderTotals watched_render(
    const Engine& engine, ImageSize size, unsigned threads, const std::string& what, const RowSink& sink,
    const std::function<void()>& tick = [] {});

/// The whole image, rendered so.
Image watched_image(const Engine& engine, ImageSize size, unsigned threads, const std::string& what);

/// The number of threads that watched_render() uses for `wanted`.
unsigned thread_count(unsigned wanted);

}  // namespace raylab::cli
