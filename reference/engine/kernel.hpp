#pragma once

#include "core/render/engine.hpp"
#include "reference/engine/formulas.hpp"
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

/// The kernels by the formulas that the namespaces say. scalar_kernel: one number at a time, in the instructions that every
/// machine has. pack_kernels(): those with packs that this machine can run, the widest first.
#define RAYLAB_DECLARE_KERNELS(formulas) \
  namespace formulas {                   \
  extern const Kernel scalar_kernel;     \
  std::vector<Kernel> pack_kernels();    \
  }
RAYLAB_DECLARE_KERNELS(foot_log1p)
RAYLAB_DECLARE_KERNELS(foot_cosine)
RAYLAB_DECLARE_KERNELS(textbook_log1p)
RAYLAB_DECLARE_KERNELS(textbook_cosine)
#undef RAYLAB_DECLARE_KERNELS

}  // namespace raylab::fast
