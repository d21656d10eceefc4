#pragma once

// docs/model.md's formulas as printed, in its order. Its section numbers and decisions [D n] stand in the comments, and its
// symbols are the names: L, N, V, R are unit vectors, but for R0 and R, the reflected part.
#include "core/math/camera.hpp"
#include "core/math/lights.hpp"
#include "core/math/ray.hpp"
#include "core/math/sample.hpp"
#include "core/scene/scene.hpp"
#include "reference/oracle/number.hpp"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace raylab::oracle {

// ---- 1 Rays ---------------------------------------------------------------------------------------------------------

template <class T>
struct Ray {
  Vec3<T> origin;
  Vec3<T> direction;  ///< unit
  Leaves leaves;
};

template <class T>
class Lens {
 public:
  Lens(const Camera& camera, const ImageSize& image)
      : position_(camera.position), width_(image.width), height_(image.height) {
    f_ = unit(Vec3<T>(camera.facing));
    r_ = unit(cross(f_, Vec3<T>(camera.up)));
    u_ = cross(r_, f_);
    const T theta = T(camera.half_field_of_view) * boost::math::constants::pi<T>() / 180;
    s_ = 2 * tan(theta) / std::max(image.width, image.height);
  }

  Ray<T> ray(int column, int row, const SampleOffset& sample) const {
    return through(column + 1 - width_ / 2, height_ / 2 - row, sample);
  }

  /// x, y: the handout's screen coordinates.
  Ray<T> through(const T& x, const T& y, const SampleOffset& sample) const {
    const T half = T(1) / 2;
    const Vec3<T> along = f_ + ((x - half + sample.dx) * s_) * r_ + ((y - half + sample.dy) * s_) * u_;
    return {position_, unit(along), {}};
  }

 private:
  Vec3<T> position_, f_, r_, u_;
  T width_, height_, s_;
};

// ---- 2 Intersections ------------------------------------------------------------------------------------------------

/// The one t >= 0 with (o + t d - c).n = 0.
template <class T>
std::optional<T> meet_plane(const Ray<T>& ray, const Vec3<T>& c, const Vec3<T>& n) {
  const T slope = dot(ray.direction, n);
  if (sign(slope, T(1)) == 0) return std::nullopt;  // parallel, or in the plane
  const T height = dot(c - ray.origin, n);
  if (sign(height, size(c) + size(ray.origin)) == 0) return T(0);
  const T t = height / slope;
  return t > 0 ? std::optional<T>(t) : std::nullopt;
}

/// The line of a ray and a sphere: |o + t d - c| = R where t^2 + 2 b t + gap = 0.
template <class T>
struct Chord {
  T b;
  T gap;
  T scale;    ///< of the numbers that gap and discriminant are made of
  int place;  ///< of the origin: -1 inside, 0 on the sphere, 1 outside

  Chord(const Ray<T>& ray, const Vec3<T>& c, const T& radius) {
    const Vec3<T> f = ray.origin - c;
    const T squared = radius * radius;
    b = dot(f, ray.direction);
    gap = dot(f, f) - squared;
    scale = size(f) * (size(ray.origin) + size(c)) + squared;
    place = sign(gap, scale);
  }

  T discriminant() const { return b * b - gap; }
  bool exists() const { return place <= 0 || sign(discriminant(), scale) >= 0; }
  /// Half the distance between the two roots.
  T half() const { return place == 0 ? T(abs(b)) : sign(discriminant(), scale) == 0 ? T(0) : sqrt(discriminant()); }
};

/// The least t >= 0 on the sphere.
template <class T>
std::optional<T> meet_sphere(const Ray<T>& ray, const Vec3<T>& c, const T& radius) {
  const Chord<T> chord(ray, c, radius);
  if (chord.place == 0) return T(0);
  if (chord.place < 0) return T(-chord.b + chord.half());
  if (chord.b >= 0 || !chord.exists()) return std::nullopt;
  return T(-chord.b - chord.half());
}

/// Where a ray that leaves a sphere inwards meets its far side (D6).
template <class T>
T meet_far_side(const Ray<T>& ray, const Vec3<T>& c) {
  return std::max(T(0), T(-2 * dot(ray.origin - c, ray.direction)));
}

// ---- 3 Blinn-Phong --------------------------------------------------------------------------------------------------

template <class T>
T specular_weight(double shininess) {
  if (std::isinf(shininess)) return T(1);
  const T half = T(shininess) / 400;
  if (half * half < std::numeric_limits<T>::epsilon()) return half;  // where 1 - e has no digits left; off by half^3 / 3
  const T e = exp(-T(shininess) / 200);
  return (1 - e) / (1 + e);
}

/// k_s max(0, H.N)^alpha.
template <class T>
T specular(const Vec3<T>& L, const Vec3<T>& N, const Vec3<T>& V, const T& k_s, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return T(0);  // k_s = 0; D10
  const Vec3<T> sum = L + V;
  if (sign(size(sum), T(1)) == 0) return T(0);
  const T cosine = dot(unit(sum), N);
  return cosine > 0 ? T(k_s * pow(cosine, T(alpha))) : T(0);
}

/// A light as a point sees it.
template <class T>
struct Lamp {
  Vec3<T> L;
  std::optional<T> distance;  ///< nothing: infinite
  T strength;                 ///< I, or I/(1 + r)^2
};

/// A point light as p sees it; nothing if it is at p itself.
template <class T>
std::optional<Lamp<T>> lamp_at(const PointLight& light, const Vec3<T>& p) {
  const Vec3<T> position(light.position);
  const T r = length(position - p);
  if (sign(r, T(size(position) + size(p))) == 0) return std::nullopt;
  return Lamp<T>{(position - p) / r, r, light.intensity / ((1 + r) * (1 + r))};
}

/// L.N > 0: is the light above the surface? (D9)
template <class T>
bool above(const Lamp<T>& lamp, const Vec3<T>& N) {
  return sign(dot(lamp.L, N), T(1)) > 0;
}

/// What a surface sends back of a light that reaches it, before its color: with L.N > 0 both terms, else, where each dot
/// product is clamped by itself, the second.
template <class T>
T from_light(const Lamp<T>& lamp, const Vec3<T>& N, const Vec3<T>& V, const T& k_s, double alpha) {
  const T highlight = specular(lamp.L, N, V, k_s, alpha);
  return lamp.strength * (above(lamp, N) ? T(dot(lamp.L, N) + highlight) : highlight);
}

// ---- 5 Reflections, 6 Refraction ------------------------------------------------------------------------------------

/// D13.
template <class T>
Vec3<T> reflect(const Vec3<T>& d, const Vec3<T>& N) {
  return d - (2 * dot(d, N)) * N;
}

/// The square of the cosine on the far side of a surface, by Snell's law: sin_far = ratio sin_near. Below 0 where that is
/// above 1.
template <class T>
T refracted_cosine_squared(const T& cos_near, const T& ratio) {
  return 1 - ratio * ratio * (1 - cos_near * cos_near);
}

/// The cosine itself, or nothing.
template <class T>
std::optional<T> refracted_cosine(const T& cos_near, const T& ratio) {
  const T squared = refracted_cosine_squared(cos_near, ratio);
  const int side = sign(squared, T(1 + ratio * ratio));
  if (side < 0) return std::nullopt;
  return side == 0 ? T(0) : sqrt(squared);
}

/// The direction on the far side: its part along the surface is `ratio` that of d, the rest goes against N.
template <class T>
Vec3<T> refract(const Vec3<T>& d, const Vec3<T>& N, const T& ratio, const T& cos_far) {
  return ratio * (d - dot(d, N) * N) - cos_far * N;
}

/// R, by Schlick. `cosine` is on the air side.
template <class T>
T schlick(const T& cosine, const T& n) {
  const T R0 = (1 - n) * (1 - n) / ((1 + n) * (1 + n));
  const T rest = 1 - std::clamp(cosine, T(0), T(1));
  return R0 + (1 - R0) * rest * rest * rest * rest * rest;
}

/// Snell's law for a ray that meets glass on one side: sin_far = ratio sin_near.
template <class T>
T snell_ratio(Side side, const T& n) {
  return side == Side::outwards ? T(1 / n) : n;
}

/// What becomes of a ray that meets glass.
template <class T>
struct Split {
  T ratio;                   ///< of Snell's law
  std::optional<T> cos_far;  ///< nothing at total reflection
  T R;                       ///< 1 at total reflection (D16); else by Schlick, from outside or from inside (D17)
};

template <class T>
Split<T> split_at_glass(const T& cos_near, Side side, const T& n) {
  const T ratio = snell_ratio(side, n);
  const std::optional<T> cos_far = refracted_cosine(cos_near, ratio);
  return {ratio, cos_far, cos_far ? schlick(side == Side::outwards ? cos_near : *cos_far, n) : T(1)};
}

/// The exit ray of a ray that has just entered a glass sphere: out at the second point, whatever else is inside (D15). In
/// exact arithmetic it leaves at the angle at which it came, so there is always one.
template <class T>
Ray<T> exit_ray(const Ray<T>& inside, const Vec3<T>& c, const T& n) {
  const Vec3<T> second = inside.origin + meet_far_side(inside, c) * inside.direction;
  const Vec3<T> N = unit(c - second);
  const T cos_out = refracted_cosine(T(-dot(inside.direction, N)), n).value_or(T(0));
  return {second, refract(inside.direction, N, n, cos_out), {inside.leaves.geometry, Side::outwards}};
}

// ---- 7 SSAA ---------------------------------------------------------------------------------------------------------

/// The clamp (D18).
template <class T>
Vec3<T> clamped(const Vec3<T>& c) {
  const auto clamp = [](const T& x) { return std::clamp(x, T(0), T(1)); };
  return {clamp(c.x), clamp(c.y), clamp(c.z)};
}

}  // namespace raylab::oracle
