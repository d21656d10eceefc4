// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// The distance at which a ray from `o` along `d` meets the plane through `c` with unit normal `n`, or something that is not
/// >= 0 (also a NaN or an infinity) for a miss.
template <class V>
RAYLAB_INLINE V plane_distance(const Vec3<V>& o, const Vec3<V>& d, const Vec3<V>& c, const Vec3<V>& n) {
  const V slope = dot(d, n);
  return select(slope == V(0), V(-1), dot(c - o, n) / slope);
}

/// How a ray's line passes the center of a sphere. The foot is the point of the line nearest the center, and `perp` the
/// vector to it from there. Measured so, a far and small sphere keeps its radius, which the textbook's b^2 - 4ac loses to
/// cancellation.
template <class V>
struct Passing {
  V foot;        ///< its distance along the ray, (c - o).d; below 0 behind the origin
  Vec3<V> perp;  ///< from the foot to the center
  V apart;       ///< |perp|^2
};

template <class V>
RAYLAB_INLINE Passing<V> pass(const Vec3<V>& o, const Vec3<V>& d, const Vec3<V>& c) {
  const Vec3<V> to_center = c - o;
  const V foot = dot(to_center, d);
  const Vec3<V> perp = to_center - foot * d;
  if constexpr (formulas.sphere == SphereFormula::textbook) return {foot, perp, dot(to_center, to_center) - foot * foot};
  return {foot, perp, dot(perp, perp)};
}

/// Where a ray meets a sphere.
template <class V>
struct Meeting {
  MaskOf<V> met;     ///< does it?
  V t;               ///< the least t >= 0
  V half;            ///< half the chord
  MaskOf<V> inside;  ///< did the ray come from inside?
};

/// Of rays that start near the surface: there the gap, computed without error, knows more than the foot, whose error is that
/// of R^2. From afar it is the other way round.
template <class V>
RAYLAB_INLINE Meeting<V> meet_nearby(const Vec3<V>& o, const Vec3<V>& d, const Vec3<V>& c, V radius) {
  const V foot = dot(c - o, d);
  const V gap = gap_to_sphere(o, c, radius);
  const V discriminant = foot * foot - gap;
  const V half = square_root(greatest(V(0), discriminant));
  const MaskOf<V> touches = gap == V(0);
  const MaskOf<V> outside = (gap > V(0)) | (touches & (foot >= V(0)));
  const MaskOf<V> inside = !outside;
  const V from_outside = select(touches, V(0), gap / (half + foot));
  const V from_inside = select(foot < V(0), -gap / (half - foot), half + foot);
  const MaskOf<V> met = (discriminant >= V(0)) & (inside | touches | (foot > V(0)));
  return {met, select(outside, from_outside, from_inside), half, inside};
}

/// How far outside the sphere rays start: distance^2 - radius^2, with an error of roundings of R^2.
template <class V>
RAYLAB_INLINE V rough_gap(const Passing<V>& passing, V radius) {
  return passing.foot * passing.foot - (radius * radius - passing.apart);
}

/// The gap below which it must be known without error; the textbook never asks.
template <class V>
RAYLAB_INLINE V nearness(V radius) {
  return V(formulas.sphere == SphereFormula::textbook ? 0.0f : 1.0f / 16) * (radius * radius);
}

/// Those of `asked` that start inside the sphere or near its surface, compared with its radius. They are rare, and what is
/// done for them is in functions of its own: so the other rays need not keep at hand what those need.
template <class V>
RAYLAB_INLINE MaskOf<V> starts_within(MaskOf<V> asked, const Passing<V>& passing, V radius) {
  return asked & (rough_gap(passing, radius) < nearness(radius));
}

/// Of the rays of `asked`, which start outside and not near the surface.
template <class V>
RAYLAB_INLINE Meeting<V> meet_from_afar(MaskOf<V> asked, const Passing<V>& passing, V radius) {
  const V discriminant = radius * radius - passing.apart;
  const V half = square_root(greatest(V(0), discriminant));
  const MaskOf<V> met = asked & (discriminant >= V(0)) & (passing.foot > V(0));
  return {met, passing.foot - half, half, mask_of<V>(0)};
}

/// Of the rays of `asked`, which start inside and not near the surface.
template <class V>
RAYLAB_INLINE Meeting<V> meet_from_inside(MaskOf<V> asked, const Passing<V>& passing, V radius) {
  const V half = square_root(greatest(V(0), radius * radius - passing.apart));
  return {asked, passing.foot + half, half, asked};
}

/// Lane by lane.
template <class V>
RAYLAB_INLINE Meeting<V> select(MaskOf<V> condition, const Meeting<V>& yes, const Meeting<V>& no) {
  return {select(condition, yes.met, no.met), select(condition, yes.t, no.t), select(condition, yes.half, no.half),
          select(condition, yes.inside, no.inside)};
}

/// Of the rays of `asked`, from wherever they start.
template <class V>
[[gnu::noinline]] Meeting<V> meet(MaskOf<V> asked, Vec3<V> o, Vec3<V> d, Vec3<V> c, V radius) {
  const Passing<V> passing = pass(o, d, c);
  const V gap = rough_gap(passing, radius);
  const MaskOf<V> within = asked & (gap < V(0));
  const Meeting<V> far = select(within, meet_from_inside(asked, passing, radius), meet_from_afar(asked, passing, radius));
  const MaskOf<V> nearby = asked & (magnitude(gap) < nearness(radius));
  if (none(nearby)) return far;
  return select(nearby, meet_nearby(o, d, c, radius), far);
}

/// The distance at which a ray that starts on a sphere and leaves it inwards meets its far side (D6).
template <class V>
RAYLAB_INLINE V far_side(const Passing<V>& passing) {
  return greatest(V(0), V(2) * passing.foot);
}

}  // namespace raylab::fast::RAYLAB_TARGET
