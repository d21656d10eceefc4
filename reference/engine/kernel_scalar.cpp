// The kernel for single numbers.

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

#define RAYLAB_TARGET scalar
#define RAYLAB_INLINE inline
#define RAYLAB_ATTRIBUTE
#include "reference/engine/kernel/parts.hpp"

namespace raylab::fast {

const Kernel scalar_kernel = {"scalar", 0, 1, 1, scalar::trace_rows<float>, scalar::trace_rows<double>};

}  // namespace raylab::fast
