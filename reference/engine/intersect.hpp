#pragma once

#include "reference/engine/exact.hpp"
#include "reference/engine/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace raylab::fast {

/// The distance at which a ray from `o` along `d` meets the plane through `c` with unit normal `n`, or something that is not
/// >= 0 (also a NaN or an infinity) for a miss.
template <class T>
constexpr T plane_distance(const Vec3<T>& o, const Vec3<T>& d, const Vec3<T>& c, const Vec3<T>& n) {
  const T slope = dot(d, n);
  return slope == 0 ? T(-1) : dot(c - o, n) / slope;
}

/// A first look at a sphere of centre `c`: false only if the ray certainly misses it, has it behind, or meets it beyond
/// `limit`.
///
/// The foot is the point of the ray nearest the centre, and `perp` the vector to it from there. Measured so, a far and small
/// sphere keeps its radius, which the textbook's b^2 - 4ac loses to cancellation. The margins are the rounding errors of the
/// quantities they are added to.
template <class T>
bool may_meet_sphere(const Vec3<T>& o, const Vec3<T>& d, const Vec3<T>& c, T radius, T limit) {
  constexpr T margin = 8 * std::numeric_limits<T>::epsilon();
  const Vec3<T> f = o - c;
  const T b = dot(f, d);
  const Vec3<T> perp = f - b * d;
  const T reach = std::abs(b) + radius;
  const T discriminant = radius * radius - dot(perp, perp) + margin * radius * reach;
  if (!(discriminant >= 0)) return false;
  const T half = std::sqrt(discriminant) + margin * reach;
  return b <= half && -b - half <= limit;
}

/// Where a ray meets a sphere.
template <class T>
struct SphereMeeting {
  T t;
  Vec3<T> outwards;  ///< from the centre to the point, not yet a unit vector
  bool inside;       ///< did the ray come from inside?
};

/// The least t >= 0 at which the ray meets the sphere, with an error of a few roundings of t itself as far as the direction
/// allows. Dearer than may_meet_sphere, and only asked after it.
template <class T>
std::optional<SphereMeeting<T>> meet_sphere(const Vec3<T>& o, const Vec3<T>& d, const Vec3<T>& c, T radius) {
  const Vec3<T> f = o - c;
  const T b = dot(f, d);
  const Vec3<T> perp = f - b * d;
  const T gap = gap_to_sphere(o, c, radius);
  if (gap > 0 && b >= 0) return std::nullopt;
  // Near the sphere the gap knows more than the foot, whose error is that of R^2; from afar it is the other way round.
  const bool near = gap < radius * radius;
  const T discriminant = near ? b * b - gap : radius * radius - dot(perp, perp);
  if (!(discriminant >= 0)) return std::nullopt;
  const T half = std::sqrt(discriminant);
  if (gap > 0) return SphereMeeting<T>{gap / (half - b), perp - half * d, false};
  if (b > 0) return SphereMeeting<T>{-gap / (half + b), perp + half * d, true};
  if (gap < 0) return SphereMeeting<T>{half - b, perp + half * d, true};
  return SphereMeeting<T>{T(0), f, false};
}

/// Where a ray that starts on a sphere and leaves it inwards meets its far side (D6).
template <class T>
SphereMeeting<T> meet_far_side(const Vec3<T>& o, const Vec3<T>& d, const Vec3<T>& c) {
  const Vec3<T> f = o - c;
  const T t = std::max(T(0), T(-2) * dot(f, d));
  return {t, f + t * d, true};
}

}  // namespace raylab::fast
