#pragma once

#include "core/math/vec3.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstdint>
#include <limits>

namespace raylab::oracle {

/// The number types that pixels are computed in: 113 bits (34 decimal digits), 237 bits (71) and, for pixels on which those
/// two disagree, 493 bits (148). Their exponents reach far enough that neither the square of the largest double nor that of
/// the smallest leaves their range. All of it is on the stack.
using Coarse = boost::multiprecision::cpp_bin_float_quad;
using Fine = boost::multiprecision::cpp_bin_float_oct;
using Finest = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<493, boost::multiprecision::digit_base_2, void, std::int32_t, -262142, 262143>,
    boost::multiprecision::et_off>;

/// A vector of numbers that GLM knows nothing of.
template <class T>
struct Vec3 {
  T x, y, z;

  Vec3() : x(0), y(0), z(0) {}
  Vec3(const T& x_, const T& y_, const T& z_) : x(x_), y(y_), z(z_) {}
  /// The doubles of a scene are exact numbers.
  explicit Vec3(const raylab::Vec3& v) : x(v.x), y(v.y), z(v.z) {}

  Vec3& operator+=(const Vec3& b) { return *this = *this + b; }

  friend bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const T& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Vec3 operator/(const Vec3& a, const T& s) { return {a.x / s, a.y / s, a.z / s}; }
};

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T length(const Vec3<T>& a) {
  return sqrt(dot(a, a));
}

/// `a` must not be zero.
template <class T>
Vec3<T> unit(const Vec3<T>& a) {
  return a / length(a);
}

/// How large the numbers in `a` are: the sum of its components' sizes. For `sign` only.
template <class T>
T size(const Vec3<T>& a) {
  return abs(a.x) + abs(a.y) + abs(a.z);
}

/// -1, 0 or 1: the sign of `value`, worked out from numbers of about `scale`, on which a decision hangs (hit or miss, nearer
/// or farther, lit or not).
///
/// Rounding makes an exact zero (a light in the very plane of a blocker, a tangent ray, two surfaces that touch) into
/// anything up to some 2^-113 of the scale, with a sign that means nothing. So whatever is smaller than three quarters of
/// the bits can tell counts as the zero that docs/model.md speaks of. A value that is that small but not zero is seen as
/// such by the finer type: then the two types decide differently, and a still finer one is asked.
template <class T>
int sign(const T& value, const T& scale) {
  static const T smallest = ldexp(T(1), -std::numeric_limits<T>::digits * 3 / 4);
  const T threshold = smallest * scale;
  return value > threshold ? 1 : value < -threshold ? -1 : 0;
}

}  // namespace raylab::oracle
