#pragma once

#include "reference/engine/prepared.hpp"
#include "reference/engine/vec3.hpp"

#include <cmath>

namespace raylab::fast {

/// max(0, h.n)^alpha with h = unit(l + v). As 1 - h.n = |h - n|^2 / 2, a shiny highlight's peak keeps the bits that a cosine
/// rounded next to 1 has lost: 12 of them at alpha = 1000.
template <class T>
T highlight(const Vec3<T>& l, const Vec3<T>& n, const Vec3<T>& v, T alpha) {
  const Vec3<T> sum = l + v;
  const T size = length(sum);
  if (size == 0) return 0;
  const Vec3<T> apart = sum / size - n;
  const T one_minus_cosine = T(0.5) * dot(apart, apart);
  return one_minus_cosine < 1 ? std::exp(alpha * std::log1p(-one_minus_cosine)) : T(0);
}

/// What a light in direction `l` with `cosine` = l.n > 0 gives, before its strength and the surface's color.
template <class T>
T blinn_phong(const Vec3<T>& l, T cosine, const Vec3<T>& n, const Vec3<T>& v, const Finish<T>& finish) {
  return finish.highlight > 0 ? cosine + finish.highlight * highlight(l, n, v, finish.alpha) : cosine;
}

/// `light` on a surface of color `color`. Light beyond the largest number is infinite, but black stays black.
template <class T>
Vec3<T> tinted(T light, const Vec3<T>& color) {
  const auto part = [light](T c) { return c > 0 ? light * c : T(0); };
  return {part(color.x), part(color.y), part(color.z)};
}

/// d mirrored at a surface with unit normal n.
template <class T>
Vec3<T> reflected(const Vec3<T>& d, const Vec3<T>& n) {
  return straightened(d - (T(2) * dot(d, n)) * n);
}

}  // namespace raylab::fast
