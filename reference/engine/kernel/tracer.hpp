// Part of the kernel; kernel/parts.hpp says how the parts are put together.

namespace raylab::fast::RAYLAB_TARGET {

/// The rays that wait, the last come first. They are large, so they stay where they are put: what moves are their numbers.
template <class Waiting>
class WaitingRays {
 public:
  WaitingRays() {
    for (std::size_t i = 0; i < most; ++i) free_[i] = static_cast<std::uint8_t>(i);
  }

  bool empty() const { return size_ == 0; }

  /// To be filled in.
  Waiting& push() {
    const std::uint8_t place = free_[size_ + held_];
    order_[size_++] = place;
    return rays_[place];
  }

  /// Valid until release().
  const Waiting& pop() {
    ++held_;
    return rays_[order_[--size_]];
  }

  void release(const Waiting& rays) {
    --held_;
    free_[size_ + held_] = static_cast<std::uint8_t>(&rays - rays_.data());
  }

 private:
  static constexpr std::size_t most = most_bounces + 2;

  std::array<Waiting, most> rays_;
  std::array<std::uint8_t, most> order_, free_;  // of free_, the places from size_ + held_ on
  std::size_t size_ = 0, held_ = 0;
};

/// What a kernel is compiled for, so that scenes without it neither ask nor keep registers for it.
struct Needs {
  bool planes;
  bool bounces;  ///< off mirrors and through glass
};

/// Follows the rays of a few pixels at a time, one in each lane, through a prepared scene. Lanes never mix: what one holds
/// does not depend on the others, nor on how many there are. One for each call of trace_rows: it holds the rays that wait,
/// the counts, and nothing that one pixel could pass on to the next.
template <class V, Needs needs>
class Tracer {
 public:
  using T = NumberOf<V>;
  using Mask = MaskOf<V>;
  using Index = IndexOf<V>;

  Tracer(const Prepared<T>& scene, RayCounts& counts, const std::atomic<bool>& cancel)
      : scene_(scene), nearest_(scene), lighting_(scene), counts_(counts), cancel_(cancel) {}

  /// The color at the end of primary rays. Glass splits a ray in two: those to come wait on a stack, which never holds more
  /// than one for each bounce.
  RAYLAB_INLINE Vec3<V> color(const Ray<V>& primary_rays, Mask lanes) {
    Vec3<V> sum = select(lanes, surface_color<true>({primary_rays, V(1), lanes, 0}), zero<V>());
    if constexpr (needs.bounces) {
      while (!waiting_.empty()) {
        const Waiting& next = waiting_.pop();
        sum = select(next.lanes, sum + next.weight * next_surface_color(next), sum);
        waiting_.release(next);
      }
    }
    return sum;
  }

 private:
  /// A ray to be traced in each lane of `lanes`, and how much of its color reaches the pixel.
  struct Waiting {
    Ray<V> ray;
    V weight;
    Mask lanes;
    int bounce;
  };

  /// The color that the nearest surface itself sends back; the rays that it sends on are added to those that wait.
  /// `primary` as in NearestSearch::nearest_surface().
  template <bool primary>
  RAYLAB_INLINE Vec3<V> surface_color(const Waiting& from) {
    if (cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
    const Nearest<V> nearest = nearest_.template nearest_surface<primary>(from.ray, from.lanes);
    const Mask met = from.lanes & (nearest.place >= Index(0));
    if (none(met)) return spread<V>(scene_.background);
    const Places<V> places(nearest.place, met);
    const Look<V> look(scene_, places);
    if (scene_.settings.stage == 2) return select(met, look.color(), spread<V>(scene_.background));
    const Hit<V> hit = nearest_.hit_at(from.ray, nearest, places, met);
    if constexpr (needs.bounces) {
      if (scene_.features.glass) {
        const Mask glass = met & (look[is_glass] > V(0));
        if (any(glass)) return glass_color(from, hit, look, places, met, glass);
      }
      if (scene_.features.mirrors && goes_on(from)) send_reflected(from, hit, look[mirror], met);
    }
    return select(met, lit_color(from, hit, look, met), spread<V>(scene_.background));
  }

  [[gnu::noinline]] Vec3<V> next_surface_color(const Waiting& from) { return surface_color<false>(from); }

  /// The same where the surfaces of `glass` are glass, which sends all its light on.
  [[gnu::noinline]] Vec3<V> glass_color(const Waiting& from, const Hit<V>& hit, const Look<V>& look, const Places<V>& places,
                                        Mask met, Mask glass) {
    if (goes_on(from)) send_from_glass(from, hit, look, nearest_.balls_at(places, glass), met, glass);
    const Mask lit = without(met, glass);
    const Vec3<V> seen = any(lit) ? lit_color(from, hit, look, lit) : zero<V>();
    return select(lit, seen, select(glass, zero<V>(), spread<V>(scene_.background)));
  }

  RAYLAB_INLINE Vec3<V> lit_color(const Waiting& from, const Hit<V>& hit, const Look<V>& look, Mask lit) {
    return tinted(lighting_.light_on(hit, from.ray.direction, look, lit, counts_), look.color());
  }

  bool goes_on(const Waiting& from) const { return from.bounce < scene_.settings.max_bounces; }

  void send_reflected(const Waiting& from, const Hit<V>& hit, V weight, Mask lanes) {
    send(from, {hit.point, mirrored(from.ray.direction, hit.normal), hit.place, hit.inside}, weight, lanes,
         counts_.reflected);
  }

  /// From glass in the lanes of `glass`, which sends on two rays, and from mirrors in the others.
  void send_from_glass(const Waiting& from, const Hit<V>& hit, const Look<V>& look, const Ball<V>& ball, Mask met,
                       Mask glass) {
    const Vec3<V>& d = from.ray.direction;
    const Glass<V> what = {look[ior], look[ior_squared_minus_1], look[r0]};
    const Refraction<V> refraction = refract(d, hit.normal, hit.inside, what);
    const Parts<V> parts = schlick(refraction, hit.inside, what);
    send_reflected(from, hit, select(glass, parts.reflected, look[mirror]), met);
    const Mask through = glass & (parts.refracted > V(0));
    Refracted<V> ahead = through_sphere(refraction, d, hit.normal, ball.center, ball.radius, what);
    if (any(through & hit.inside)) {
      const Refracted<V> out = out_of_sphere(refraction, d, hit.normal, hit.point, what);
      ahead = {select(hit.inside, out.origin, ahead.origin), select(hit.inside, out.direction, ahead.direction)};
    }
    send(from, {ahead.origin, ahead.direction, hit.place, mask_of<V>(0)}, parts.refracted, through, counts_.refracted);
  }

  void send(const Waiting& from, const Ray<V>& ray, V weight, Mask lanes, std::uint64_t& counter) {
    const V reaches_pixel = from.weight * weight;
    lanes = lanes & (reaches_pixel > V(0));
    if (none(lanes)) return;
    counter += count(lanes);
    wait(ray, reaches_pixel, lanes, from.bounce + 1);
  }

  /// Part by part: compilers copy a large thing byte by byte.
  RAYLAB_INLINE void wait(const Ray<V>& ray, V weight, Mask lanes, int bounce) {
    Waiting& rays = waiting_.push();
    rays.ray.origin = ray.origin;
    rays.ray.direction = ray.direction;
    rays.ray.leaves = ray.leaves;
    rays.ray.inwards = ray.inwards;
    rays.weight = weight;
    rays.lanes = lanes;
    rays.bounce = bounce;
  }

  const Prepared<T>& scene_;
  const NearestSearch<V, needs.planes> nearest_;
  const Lighting<V> lighting_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  WaitingRays<Waiting> waiting_;
};

}  // namespace raylab::fast::RAYLAB_TARGET
