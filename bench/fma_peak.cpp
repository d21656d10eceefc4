#include "bench/fma_peak.hpp"

#include <chrono>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/fma_peak.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::bench::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Ten chains: more than the latency of a fused multiply-add in two pipelines, and few enough for 16 registers.
double operations(long rounds, float& result) {
  const hn::ScalableTag<float> tag;
  const auto factor = hn::Set(tag, 0.999f), term = hn::Set(tag, 0.001f);
  auto a = hn::Iota(tag, 0.0f), b = hn::Iota(tag, 1.0f), c = hn::Iota(tag, 2.0f), d = hn::Iota(tag, 3.0f),
       e = hn::Iota(tag, 4.0f);
  auto f = hn::Iota(tag, 5.0f), g = hn::Iota(tag, 6.0f), h = hn::Iota(tag, 7.0f), i = hn::Iota(tag, 8.0f),
       j = hn::Iota(tag, 9.0f);
  for (long round = 0; round < rounds; ++round) {
    a = hn::MulAdd(a, factor, term), b = hn::MulAdd(b, factor, term), c = hn::MulAdd(c, factor, term);
    d = hn::MulAdd(d, factor, term), e = hn::MulAdd(e, factor, term), f = hn::MulAdd(f, factor, term);
    g = hn::MulAdd(g, factor, term), h = hn::MulAdd(h, factor, term), i = hn::MulAdd(i, factor, term);
    j = hn::MulAdd(j, factor, term);
  }
  const auto sum =
      hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, d)), hn::Add(hn::Add(e, f), hn::Add(hn::Add(g, h), hn::Add(i, j))));
  result = hn::GetLane(sum);
  return 2.0 * 10 * static_cast<double>(rounds) * static_cast<double>(hn::Lanes(tag));
}

}  // namespace raylab::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab::bench {

HWY_EXPORT(operations);

double fma_peak() {
  using Clock = std::chrono::steady_clock;
  float result = 0;
  HWY_DYNAMIC_DISPATCH(operations)(1000, result);
  const auto start = Clock::now();
  const double done = HWY_DYNAMIC_DISPATCH(operations)(3'000'000, result);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result == 0 ? 0 : done / seconds;
}

}  // namespace raylab::bench
#endif
