// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// The sum of terms[i] x^i.
template <class V, std::size_t n>
RAYLAB_INLINE V sum_of_powers(V x, const std::array<V, n>& terms) {
  if constexpr (n == 1) {
    return terms[0];
  } else {
    std::array<V, (n + 1) / 2> pairs;
    for (std::size_t i = 0; i < n / 2; ++i) pairs[i] = terms[2 * i + 1] * x + terms[2 * i];
    if constexpr (n % 2 == 1) pairs[n / 2] = terms[n - 1];
    return sum_of_powers(x * x, pairs);
  }
}

/// Coefficients from the constant up. By Estrin's scheme, in pairs and pairs of pairs: by Horner's each step would wait for
/// the one before.
template <class V, std::size_t n>
RAYLAB_INLINE V polynomial(V x, const std::array<NumberOf<V>, n>& coefficients) {
  std::array<V, n> terms;
  for (std::size_t i = 0; i < n; ++i) terms[i] = V(coefficients[i]);
  return sum_of_powers(x, terms);
}

/// log(cosine2 / squared), where sine2 + cosine2 = squared: squares of the legs and the hypotenuse of a triangle. Of the
/// legs the shorter one knows the angle best. For normal cosine2 > 0.
///
/// log(a/b) = 2 atanh(s) = 2s + s z r(z) with s = (a - b)/(a + b), z = s^2: near the peak a - b is -sine2 itself, else
/// powers of two are taken out so that |s| <= 0.2. So one division does both for the ratio and for the logarithm.
template <class V>
RAYLAB_INLINE V log_of_ratio(V sine2, V cosine2, V squared) {
  using T = NumberOf<V>;
  V m, k;
  split_ratio(cosine2, squared, m, k);
  const auto near_peak = sine2 < V(0.25f) * squared;
  k = select(near_peak, V(0), k);
  const V s = select(near_peak, -sine2, m - squared) / select(near_peak, squared + (squared - sine2), m + squared);
  const V z = s * s;
  const V r = polynomial(z, atanh_polynomial<T>);
  return k * V(log_2_high<T>) + ((s + s) + (s * z * r + k * V(log_2_low<T>)));
}

/// e^y for y from -cut_off to 0.
template <class V>
RAYLAB_INLINE V exponential(V y) {
  using T = NumberOf<V>;
  const V k_and_magic = y * V(T(std::numbers::log2e)) + V(magic<T>);
  const V k = k_and_magic - V(magic<T>);
  const V r = (y - k * V(log_2_high<T>)) - k * V(log_2_low<T>);
  return polynomial(r, exponential_polynomial<T>) * power_of_two(k_and_magic);
}

/// cosine^alpha for the lanes of `asked` where the cosine is positive; 0 in the others.
template <class V>
RAYLAB_INLINE V power_of_cosine(MaskOf<V> asked, V cosine, V alpha) {
  using T = NumberOf<V>;
  const V known = least(greatest(cosine, V(std::numeric_limits<T>::min())), V(1));
  const V y = alpha * log_of_ratio(V(1), known, V(1));
  const auto above = asked & (cosine > V(0)) & (y > V(-cut_off<T>));
  return select(above, exponential(select(above, y, V(0))), V(0));
}

/// max(0, H.N)^alpha with H = unit(l + v), for the lanes of `asked`; 0 in the others.
///
/// Neither H nor its angle is worked out: |l + v|^2 cos^2 and |l + v|^2 sin^2 come from the parts of l + v along n and
/// across it. A cosine rounded next to 1 would lose 12 bits of a peak at alpha = 1000; the sine keeps them.
template <class V>
RAYLAB_INLINE V highlight(MaskOf<V> asked, const Vec3<V>& l, const Vec3<V>& n, const Vec3<V>& v, V alpha) {
  using T = NumberOf<V>;
  const Vec3<V> sum = l + v;
  const V along = dot(sum, n);
  if constexpr (formulas.power == PowerFormula::cosine)
    return power_of_cosine(asked, along / square_root(dot(sum, sum)), alpha);
  const Vec3<V> across = sum - along * n;
  const V sine2 = dot(across, across);
  const V cosine2 = greatest(along * along, V(std::numeric_limits<T>::min()));
  const V squared = sine2 + cosine2;
  // log(a/b) <= 2 (a - b)/(a + b) where a <= b: what is certainly below e^-cut_off is nothing beside the cosine that it is
  // added to.
  const auto seen = asked & (along > V(0)) & (alpha * sine2 < V(cut_off<T>) * (squared + cosine2));
  if (none(seen)) return V(0);
  const V y = V(0.5f) * alpha * log_of_ratio(sine2, cosine2, squared);
  const auto above = seen & (y > V(-cut_off<T>));
  return select(above, exponential(select(above, y, V(0))), V(0));
}

}  // namespace raylab::fast::RAYLAB_TARGET
