#pragma once

#include "core/math/vec3.hpp"

#include <cmath>
#include <random>

namespace raylab::bench {

/// Random numbers, the same ones on every run and on every machine: made by sums, products and square roots alone, which
/// are rounded alike everywhere. A compiler may evaluate the arguments of a function, or the two sides of a product, in any
/// order: where two of them are random they stand in braces, or have a name each.
class Random {
 public:
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  bool chance(double probability) { return between(0, 1) < probability; }
  double sign() { return chance(0.5) ? 1 : -1; }

  /// Of any size from 2^low to 2^high: each power of two has as many numbers as the next.
  double spread(int low, int high) {
    const int exponent = whole(low, high - 1);
    return std::scalbn(between(1, 2), exponent);
  }
  double signed_spread(int low, int high) {
    const double size = spread(low, high);
    return sign() * size;
  }

  Vec3 point(double extent = 10) { return {symmetric(extent), symmetric(extent), symmetric(extent)}; }
  Vec3 color() { return {between(0.05, 1), between(0.05, 1), between(0.05, 1)}; }

  /// A unit vector.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = point(1);
      if (length(v) > 0.1 && length(v) <= 1) return unit(v);
    }
  }
  /// Any direction, a length from 2^low to 2^high.
  Vec3 vector(int low, int high) {
    const double size = spread(low, high);
    return size * direction();
  }
  /// A unit direction on the side of `n` that n.d > 0.
  Vec3 above(const Vec3& n) {
    const Vec3 d = direction();
    return dot(d, n) < 0 ? -d : d;
  }
  /// Unit vectors next to the unit vector `n`, and next to a right angle with it: `ratio` is the tangent of what is between.
  Vec3 tilted(const Vec3& n, double ratio) { return unit(n + ratio * across(n)); }
  Vec3 raised(const Vec3& n, double ratio) { return unit(across(n) + ratio * n); }

  /// A unit vector at a right angle to `n`.
  Vec3 across(const Vec3& n) {
    for (;;) {
      const Vec3 v = cross(n, direction());
      if (length(v) > 0.1 * length(n)) return unit(v);
    }
  }

 private:
  double symmetric(double extent) { return between(-extent, extent); }
  std::mt19937_64 engine_{1};
};

}  // namespace raylab::bench
