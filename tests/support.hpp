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

// Two strictnesses. raylab's own tables compute in double, by formulas that keep their digits, and are held to that. A
// submission (judging_submission()) is right in float as well, by the handout's plain formulas, and with the accepted
// variants of docs/errata.md; whatever asks for more than this is a test of its own, tagged [hard], which submissions are
// not asked.

/// How far a right answer of a submission may be off, as a part of the largest number on the way to it: 64 roundings to
/// float, each of up to 2^-24 of what is rounded, beginning with the inputs. The comparison of images allows as many
/// (docs/tolerance.md).
inline constexpr double float_tolerance = 64 * 0x1p-24;

/// The tolerance: `strict` for raylab's own tables; for submissions what float makes of numbers of this `size`. A test whose
/// task magnifies rounding (a small difference of large numbers, a division by a small one) says so by a larger size: how
/// large a number of the answer's own kind would have to be, whose rounding spoils as much.
inline double allowed(double strict, double size = 1) {
  return judging_submission() ? std::max(strict, float_tolerance * size) : strict;
}

/// "Equal but for rounding": CHECK(actual == within(1e-14, expected)). The tolerance is absolute; within of a NaN is a NaN
/// only. For submissions it is allowed() of `size`, or of what is expected if that is larger.
template <class T>
struct Within {
  double tolerance;
  T expected;
};
inline double size_of(double value) { return std::isfinite(value) ? std::abs(value) : 0; }
inline double size_of(const Vec3& v) { return std::max({size_of(v.x), size_of(v.y), size_of(v.z)}); }
template <class T>
Within<T> within(double tolerance, const T& expected, double size = 1) {
  return {allowed(tolerance, std::max(size, size_of(expected))), expected};
}

inline double deviation(double a, double b) { return a == b ? 0 : std::abs(a - b); }
inline double deviation(const Vec3& a, const Vec3& b) {
  return std::max({deviation(a.x, b.x), deviation(a.y, b.y), deviation(a.z, b.z)}) +
         (std::isnan(a.x + a.y + a.z) ? std::numeric_limits<double>::quiet_NaN() : 0);
}

inline bool operator==(double actual, const Within<double>& w) {
  return std::isnan(w.expected) ? std::isnan(actual) : deviation(actual, w.expected) <= w.tolerance;
}
inline bool operator==(const Vec3& actual, const Within<Vec3>& w) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(actual[axis] == Within<double>{w.tolerance, w.expected[axis]})) return false;
  return true;
}
inline bool operator==(const std::optional<double>& actual, const Within<double>& w) { return actual && *actual == w; }

/// Where a ray starts: CHECK(ray.origin == start_at(hit.point, ray.direction)). At `point` itself; that of a submission up
/// to 0.001 off it as well, along its direction or along the normal on that side: an accepted variant.
struct Start {
  double tolerance;
  double shift;  ///< the most that is accepted
  Vec3 point, direction;
};
inline Start start_at(const Vec3& point, const Vec3& direction, double tolerance = 0, double size = 1) {
  return {allowed(tolerance, std::max(size, size_of(point))), judging_submission() ? 0.001 : 0, point, direction};
}
inline bool operator==(const Vec3& actual, const Start& start) {
  if (actual == Within<Vec3>{start.tolerance, start.point}) return true;
  const Vec3 off = actual - start.point;
  return start.shift > 0 && length(off) <= start.shift + start.tolerance && dot(off, start.direction) >= -start.tolerance;
}

inline std::string give_or_take(double tolerance) {
  std::ostringstream stream;
  stream << std::setprecision(2) << tolerance;
  return tolerance > 0 ? ", give or take " + stream.str() : "";
}

/// A miss, to compare with: CHECK(table().plane_hit(ray, plane) == miss).
inline constexpr std::nullopt_t miss = std::nullopt;

}  // namespace raylab::test

template <>
struct Catch::StringMaker<std::optional<double>> {
  static std::string convert(const std::optional<double>& t) { return t ? raylab::test::text(*t) : "miss"; }
};
template <>
struct Catch::StringMaker<std::optional<std::size_t>> {
  static std::string convert(const std::optional<std::size_t>& place) { return place ? std::to_string(*place) : "nothing"; }
};
template <>
struct Catch::StringMaker<raylab::Side> {
  static std::string convert(raylab::Side side) { return side == raylab::Side::inwards ? "inwards" : "outwards"; }
};
template <>
struct Catch::StringMaker<std::nullopt_t> {
  static std::string convert(std::nullopt_t) { return "miss"; }
};
template <>
struct Catch::StringMaker<raylab::test::Start> {
  static std::string convert(const raylab::test::Start& s) {
    const std::string shifted = s.shift > 0 ? ", or up to " + raylab::test::text(s.shift) + " off the surface" : "";
    return raylab::test::text(s.point) + raylab::test::give_or_take(s.tolerance) + shifted;
  }
};
template <class T>
struct Catch::StringMaker<raylab::test::Within<T>> {
  static std::string convert(const raylab::test::Within<T>& w) {
    return raylab::test::text(w.expected) + raylab::test::give_or_take(w.tolerance);
  }
};
