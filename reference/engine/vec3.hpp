#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::fast {

/// The engine's own vector. T is float or double now; nothing here asks for more than arithmetic, so that it may be a pack
/// of them (GLM's functions do not survive that).
template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(T s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator/(const Vec3& a, T s) { return {a.x / s, a.y / s, a.z / s}; }
};

template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Right for vectors of any length, even one whose square is too small or too large for a T.
template <class T>
T length(const Vec3<T>& a) {
  constexpr T smallest = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();
  constexpr T largest = std::numeric_limits<T>::max() / 4;
  const T squared = dot(a, a);
  if (squared > smallest && squared < largest) [[likely]]
    return std::sqrt(squared);
  const T most = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (most == 0) return 0;
  const Vec3<T> scaled = a / most;
  return most * std::sqrt(dot(scaled, scaled));
}

template <class T>
Vec3<T> unit(const Vec3<T>& a) {
  return a / length(a);
}

/// `a`, already a unit vector but for a few roundings, with those taken back: one Newton step. Without it the length of a
/// ray that bounces often would drift.
template <class T>
constexpr Vec3<T> straightened(const Vec3<T>& a) {
  return (T(1.5) - T(0.5) * dot(a, a)) * a;
}

}  // namespace raylab::fast
