// The kernel for single numbers. RAYLAB_FORMULAS as in kernel_packs.cpp.

#ifndef RAYLAB_FORMULAS
#define RAYLAB_FORMULAS foot_log1p
#endif

#include "reference/engine/constants.hpp"
#include "reference/engine/kernel.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <numbers>
#include <tuple>

#define RAYLAB_TARGET RAYLAB_FORMULAS::scalar
#define RAYLAB_INLINE inline __attribute__((always_inline))
#define RAYLAB_ATTRIBUTE
#include "reference/engine/kernel/parts.hpp"

namespace raylab::fast::RAYLAB_FORMULAS {

const Kernel scalar_kernel = {"scalar", 0, 1, 1, scalar::trace_rows<float>, scalar::trace_rows<double>};

}  // namespace raylab::fast::RAYLAB_FORMULAS
