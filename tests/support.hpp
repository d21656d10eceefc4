#pragma once

#include "core/math/hit.hpp"
#include "core/math/vec3.hpp"
#include "tests/catch.hpp"
#include "tests/runner.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <random>
#include <string>

namespace raylab::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double pi = 3.14159265358979323846;

/// Random inputs, the same ones on every run and on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  Vec3 point(double extent = 10) { return {symmetric(extent), symmetric(extent), symmetric(extent)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = point(1);
      if (length(v) > 0.1 && length(v) <= 1) return v / length(v);
    }
  }
  /// A unit direction on the side of `n` that n.d < 0: one that arrives at a surface with this normal.
  Vec3 arriving_at(const Vec3& n) {
    const Vec3 d = direction();
    return dot(d, n) > 0 ? -d : d;
  }

 private:
  double symmetric(double extent) { return between(-extent, extent); }
  std::mt19937_64 engine_;
};

/// "Equal but for rounding": CHECK(actual == within(1e-14, expected)). The tolerance is absolute; a NaN is never within.
template <class T>
struct Within {
  double tolerance;
  T expected;
};
template <class T>
Within<T> within(double tolerance, const T& expected) {
  return {tolerance, expected};
}

inline double deviation(double a, double b) { return a == b ? 0 : std::abs(a - b); }
inline double deviation(const Vec3& a, const Vec3& b) {
  return std::max({deviation(a.x, b.x), deviation(a.y, b.y), deviation(a.z, b.z)}) +
         (std::isnan(a.x + a.y + a.z) ? std::numeric_limits<double>::quiet_NaN() : 0);
}

inline bool operator==(double actual, const Within<double>& w) { return deviation(actual, w.expected) <= w.tolerance; }
inline bool operator==(const Vec3& actual, const Within<Vec3>& w) { return deviation(actual, w.expected) <= w.tolerance; }
inline bool operator==(const std::optional<double>& actual, const Within<double>& w) { return actual && *actual == w; }

/// A miss, to compare with: CHECK(table().plane_hit(ray, plane) == miss).
inline constexpr std::nullopt_t miss = std::nullopt;

}  // namespace raylab::test

template <>
struct Catch::StringMaker<std::optional<double>> {
  static std::string convert(const std::optional<double>& t) { return t ? raylab::test::text(*t) : "miss"; }
};
template <>
struct Catch::StringMaker<std::nullopt_t> {
  static std::string convert(std::nullopt_t) { return "miss"; }
};
template <class T>
struct Catch::StringMaker<raylab::test::Within<T>> {
  static std::string convert(const raylab::test::Within<T>& w) {
    return raylab::test::text(w.expected) + " within " + raylab::test::text(w.tolerance);
  }
};
