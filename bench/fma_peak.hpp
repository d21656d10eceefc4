#pragma once

#include <string_view>

namespace raylab::bench {

/// Floating-point operations a second of one core that does nothing but independent fused multiply-adds in float, with the
/// widest registers of the machine: what its arithmetic could do at best. Takes about 20 ms.
double fma_peak();

}  // namespace raylab::bench
