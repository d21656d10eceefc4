#pragma once

#include "core/render/engine.hpp"
#include "reference/engine/prepared.hpp"

#include <atomic>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace raylab::fast {

/// Engine::trace_rows for a prepared scene.
template <class T>
using TraceRows = void (*)(const Prepared<T>& scene, int first_row, std::span<Color> pixels, RayCounts& counts,
                           const std::atomic<bool>& cancel);

/// The kernel as it was compiled for one instruction set.
struct Kernel {
  std::string_view simd;  ///< "avx512", "avx2", "sse4", "neon", or "scalar"
  std::int64_t target;    ///< Highway's bit; 0 for scalar
  int lanes_f32, lanes_f64;
  TraceRows<float> trace_f32;
  TraceRows<double> trace_f64;
};

/// One number at a time, in the instructions that every machine has.
extern const Kernel scalar_kernel;

/// The kernels with packs that this machine can run, the widest first.
std::vector<Kernel> pack_kernels();

}  // namespace raylab::fast
