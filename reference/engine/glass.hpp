#pragma once

#include "reference/engine/prepared.hpp"
#include "reference/engine/vec3.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::fast {

/// What glass does with a ray of direction d at a unit normal N turned to its side, cos_theta = -d.N.
///
/// In the vector form of Snell's law, n_to T = n_from d - g N, the angle and every square root but one drop out: with
/// k = n^2 - 1 the root is q = sqrt(k + cos^2), and g = k / (q + cos) has no cancellation. Fifteen times faster than
/// asin and sin, and exact where theirs reports a total reflection that does not exist.
template <class T>
struct Refraction {
  T cosine;    ///< -d.N, 0 to 1
  T q;         ///< n times the cosine of the ray in the glass (met from outside), or the cosine in air (from inside)
  bool total;  ///< total reflection: there is no refracted ray

  /// From outside, n cos_2 = sqrt(n^2 - 1 + cos_1^2). Total only for n < 1 (D16).
  static Refraction from_outside(const Vec3<T>& d, const Vec3<T>& n, const Finish<T>& glass) {
    const T cosine = std::clamp(-dot(d, n), T(0), T(1));
    return with(cosine, glass.n_squared_minus_1 + cosine * cosine);
  }

  /// From inside, cos_air = sqrt(1 - n^2 sin^2) = sqrt((n cos)^2 - (n^2 - 1)) (D17).
  static Refraction from_inside(const Vec3<T>& d, const Vec3<T>& n, const Finish<T>& glass) {
    const T cosine = std::clamp(-dot(d, n), T(0), T(1));
    return with(cosine, glass.n * glass.n * cosine * cosine - glass.n_squared_minus_1);
  }

 private:
  static Refraction with(T cosine, T q_squared) { return {cosine, std::sqrt(std::max(T(0), q_squared)), q_squared < 0}; }
};

/// How glass divides the light: R by Schlick, and 1 - R, neither of them by subtraction from the other: both may be tiny.
template <class T>
struct Parts {
  T reflected;
  T refracted;
};

/// `cosine` is on the air side.
template <class T>
Parts<T> schlick(T cosine, const Finish<T>& glass) {
  const T m = T(1) - std::clamp(cosine, T(0), T(1));
  const T m5 = (m * m) * (m * m) * m;
  return {glass.r0 + (T(1) - glass.r0) * m5, (T(1) - glass.r0) * (T(1) - m5)};
}

/// Where a ray starts that has been refracted, and which way it runs.
template <class T>
struct Refracted {
  Vec3<T> origin;
  Vec3<T> direction;
};

/// Through a sphere of centre `c`, in and out, in closed form: the exit point is opposite in the plane of incidence, and the
/// ray is turned by g towards each of the two normals alike.
template <class T>
Refracted<T> through_sphere(const Refraction<T>& in, const Vec3<T>& d, const Vec3<T>& n, const Vec3<T>& c, T radius,
                            const Finish<T>& glass) {
  const T g = glass.n_squared_minus_1 / (in.q + in.cosine);
  const Vec3<T> inside = (d - g * n) / glass.n;          // T, the direction in the glass
  const Vec3<T> middle = n + (in.q / glass.n) * inside;  // half way between the normals of entry and exit
  const Vec3<T> exit_normal = straightened(T(2) * middle - n);
  return {c + radius * exit_normal, straightened(d - (T(2) * g) * middle)};
}

/// Out of a sphere into the air, at the point `p`.
template <class T>
Refracted<T> out_of_sphere(const Refraction<T>& out, const Vec3<T>& d, const Vec3<T>& n, const Vec3<T>& p,
                           const Finish<T>& glass) {
  const T g = glass.n_squared_minus_1 / (glass.n * out.cosine + out.q);
  return {p, straightened(glass.n * d + g * n)};
}

}  // namespace raylab::fast
