// The kernel for packs, once for each instruction set. Highway includes this file again and again, each time with another
// namespace HWY_NAMESPACE and with the compiler set to another instruction set.
//
// With RAYLAB_FORMULAS defined as one of the namespaces of formulas.hpp, the same by those formulas.

// SSSE3 is too old to be worth its compile time, and AVX3_DL has nothing for us that AVX3 has not. A vector of SVE or RVV,
// whose size is known at run time only, can be no member of a class.
#define RAYLAB_UNUSABLE (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // minutes for each target: one will do for one text
#define HWY_DISABLED_TARGETS (RAYLAB_UNUSABLE | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS RAYLAB_UNUSABLE
#endif
#ifdef __SSSE3__  // the compiler was told which machine it is for: then that is the only one
#define HWY_COMPILE_ONLY_STATIC
#endif

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

// Masks of AVX-512 are whole numbers, which the compiler keeps in registers of either kind; by intrinsics g++ would keep
// them among the vectors, whose units are busy.
#define HWY_COMPILER_HAS_MASK_INTRINSICS 0

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/engine/kernel_packs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128  // the scalar kernel does better
HWY_BEFORE_NAMESPACE();
#undef RAYLAB_TARGET
#undef RAYLAB_INLINE
#undef RAYLAB_ATTRIBUTE
#undef RAYLAB_PACKS
#define RAYLAB_TARGET RAYLAB_FORMULAS::HWY_NAMESPACE
#define RAYLAB_INLINE HWY_INLINE
#define RAYLAB_ATTRIBUTE HWY_ATTR
#define RAYLAB_PACKS
#include "reference/engine/kernel/parts.hpp"

namespace raylab::fast::RAYLAB_FORMULAS::HWY_NAMESPACE {

constexpr Kernel this_kernel(std::string_view name) {
  return {name,
          HWY_TARGET,
          Lanes<Pack<float>>::count,
          Lanes<Pack<double>>::count,
          trace_rows<Twin<Pack<float>>>,
          trace_rows<Twin<Pack<double>>>};
}

}  // namespace raylab::fast::RAYLAB_FORMULAS::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace raylab::fast::RAYLAB_FORMULAS {

std::vector<Kernel> pack_kernels() {
  std::vector<Kernel> kernels;
#if HWY_TARGETS & HWY_AVX3
  kernels.push_back(N_AVX3::this_kernel("avx512"));
#endif
#if HWY_TARGETS & HWY_AVX2
  kernels.push_back(N_AVX2::this_kernel("avx2"));
#endif
#if HWY_TARGETS & HWY_SSE4
  kernels.push_back(N_SSE4::this_kernel("sse4"));
#endif
#if HWY_TARGETS & HWY_NEON
  kernels.push_back(N_NEON::this_kernel("neon"));
#endif
  const std::int64_t here = hwy::SupportedTargets();
  std::erase_if(kernels, [here](const Kernel& kernel) { return (kernel.target & here) == 0; });
  return kernels;
}

}  // namespace raylab::fast::RAYLAB_FORMULAS
#endif
