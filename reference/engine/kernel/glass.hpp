// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// What the surface of glass is like.
template <class V>
struct Glass {
  V n;                  ///< refractive index
  V n_squared_minus_1;  ///< (n - 1)(n + 1), free of cancellation at n close to 1
  V r0;                 ///< what it reflects at normal incidence
};

/// What glass does with a ray of direction d at a unit normal N turned to its side, cos_theta = -d.N.
///
/// In the vector form of Snell's law, n_to T = n_from d - g N, the angle and every square root but one drop out: with
/// k = n^2 - 1 the root is q = sqrt(k + cos^2), and g = k / (q + cos) has no cancellation. Fifteen times faster than
/// asin and sin, and exact where theirs reports a total reflection that does not exist.
template <class V>
struct Refraction {
  V cosine;         ///< -d.N, 0 to 1
  V q;              ///< n times the cosine of the ray in the glass (met from outside), or the cosine in air (from inside)
  MaskOf<V> total;  ///< total reflection: there is no refracted ray
};

/// From outside, n cos_2 = sqrt(n^2 - 1 + cos_1^2): total only for n < 1 (D16). From inside,
/// cos_air = sqrt(1 - n^2 sin^2) = sqrt((n cos)^2 - (n^2 - 1)) (D17).
template <class V>
RAYLAB_INLINE Refraction<V> refract(const Vec3<V>& d, const Vec3<V>& normal, MaskOf<V> inside, const Glass<V>& glass) {
  const V cosine = least(greatest(-dot(d, normal), V(0)), V(1));
  const V n_cosine = glass.n * cosine;
  const V q_squared =
      select(inside, n_cosine * n_cosine - glass.n_squared_minus_1, glass.n_squared_minus_1 + cosine * cosine);
  return {cosine, square_root(greatest(V(0), q_squared)), q_squared < V(0)};
}

/// How glass divides the light: R by Schlick, and 1 - R, neither of them by subtraction from the other: both may be tiny.
template <class V>
struct Parts {
  V reflected;
  V refracted;
};

/// The cosine that counts is the one on the air side.
template <class V>
RAYLAB_INLINE Parts<V> schlick(const Refraction<V>& refraction, MaskOf<V> inside, const Glass<V>& glass) {
  const V cosine = least(select(inside, refraction.q, refraction.cosine), V(1));
  const V m = V(1) - cosine;
  const V m5 = (m * m) * (m * m) * m;
  const V rest = V(1) - glass.r0;
  return {select(refraction.total, V(1), glass.r0 + rest * m5), select(refraction.total, V(0), rest * (V(1) - m5))};
}

/// Where a ray starts that has been refracted, and which way it runs.
template <class V>
struct Refracted {
  Vec3<V> origin;
  Vec3<V> direction;
};

/// g, the difference of the two cosines, by way of their sum; 0 for a grazing ray at n = 1, where both are.
template <class V>
RAYLAB_INLINE V bend(const Glass<V>& glass, V cosines) {
  return glass.n_squared_minus_1 / greatest(cosines, V(std::numeric_limits<NumberOf<V>>::min()));
}

/// Through a sphere of center `c`, in and out, in closed form: the exit point is opposite in the plane of incidence, and the
/// ray is turned by g towards each of the two normals alike.
template <class V>
RAYLAB_INLINE Refracted<V> through_sphere(const Refraction<V>& in, const Vec3<V>& d, const Vec3<V>& n, const Vec3<V>& c,
                                          V radius, const Glass<V>& glass) {
  const V g = bend(glass, in.q + in.cosine);
  const V inverse_n = V(1) / glass.n;
  const Vec3<V> inside = inverse_n * (d - g * n);          // T, the direction in the glass
  const Vec3<V> middle = n + (in.q * inverse_n) * inside;  // half way between the normals of entry and exit
  const Vec3<V> exit_normal = straightened(V(2) * middle - n);
  return {c + radius * exit_normal, straightened(d - (V(2) * g) * middle)};
}

/// Out of a sphere into the air, at the point `p`.
template <class V>
RAYLAB_INLINE Refracted<V> out_of_sphere(const Refraction<V>& out, const Vec3<V>& d, const Vec3<V>& n, const Vec3<V>& p,
                                         const Glass<V>& glass) {
  const V g = bend(glass, glass.n * out.cosine + out.q);
  return {p, straightened(glass.n * d + g * n)};
}

}  // namespace raylab::fast::RAYLAB_TARGET
