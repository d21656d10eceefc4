#pragma once

// What can be said about a pixel beside its color: which other values are right too, and how near it is to a decision.
#include "reference/oracle/tracer.hpp"

#include <array>
#include <utility>

namespace raylab::oracle {

/// The shifts off the surface that docs/model.md accepts: for shadow rays, and for reflected and exit rays.
inline constexpr double greatest_shadow_shift = 0.1;
inline constexpr double greatest_bounce_shift = 0.001;
/// The shifts along the normal that are tried, for reflected and exit rays: none, up to the greatest that is accepted.
inline constexpr std::array lifts{0.0, 0.0001, 0.0003, 0.0006, 0.001};

/// One quantity in six ways: as docs/model.md has it, the least and the greatest over all shifts, and the same three with
/// each dot product clamped by itself.
template <class V>
struct Spread {
  V value, least, greatest;
  V each_value, each_least, each_greatest;

  static Spread all(const V& v) { return {v, v, v, v, v, v}; }

  template <class Function>
  static auto map(Function f, const Spread& a) -> Spread<decltype(f(a.value))> {
    return {f(a.value), f(a.least), f(a.greatest), f(a.each_value), f(a.each_least), f(a.each_greatest)};
  }

  Spread& operator+=(const Spread& b) {
    value += b.value, least += b.least, greatest += b.greatest;
    each_value += b.each_value, each_least += b.each_least, each_greatest += b.each_greatest;
    return *this;
  }

  /// `b` would be right, too.
  void include(const Spread& b) {
    least = lower(least, b.least), greatest = higher(greatest, b.greatest);
    each_least = lower(each_least, b.each_least), each_greatest = higher(each_greatest, b.each_greatest);
  }

 private:
  static V lower(const V& a, const V& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
  static V higher(const V& a, const V& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
};

template <class T>
struct Testimony {
  Spread<Vec3<T>> color;  ///< clamped
  T margin;               ///< 0 to 1
  GeometryId object;      ///< in the pixel's centre
};

/// Follows the rays of a pixel as Tracer does, and watches each decision on the way.
///
/// A shift along a ray moves no line, but skips what lies nearer than it. So between the distances at which a ray meets
/// anything, all shifts give the same, and one shift of each such interval is tried: nothing is sampled. A shift along the
/// normal moves the line, and what is seen along it changes smoothly but for decisions: half of the greatest and the
/// greatest are tried, and the parabola through the three values stands for all between.
template <class T>
class Witness {
 public:
  Witness(const World<T>& world, const std::atomic<bool>& cancel) : world_(world), tracer_(world, uncounted_, cancel) {
    for (std::size_t i = 1; i < lifts.size(); ++i) {
      const auto tracer = [&](bool clamp_each) {
        return Tracer<T>(world, uncounted_, cancel, clamp_each, Tracer<T>::unaltered, T(lifts[i]));
      };
      lifted_.push_back({tracer(false), tracer(true)});
    }
  }

  Testimony<T> pixel(int column, int row, const std::vector<SampleOffset>& samples) {
    Spread<Vec3<T>> sum{};
    for (const SampleOffset& sample : samples) {
      Light light = primary(world_.lens.ray(column, row, sample));
      if (world_.settings.stage >= 5) include_lifts(light, column, row, sample);
      sum += light;
    }
    const T count(samples.size());
    const auto resolve = [&](const Vec3<T>& total) { return clamped(total / count); };
    return {Spread<Vec3<T>>::map(resolve, sum), margin_, object_at(column, row)};
  }

 private:
  using Nearest = typename Tracer<T>::Nearest;
  using Light = Spread<Vec3<T>>;

  /// Reflected and exit rays start off the surface along its normal; with dot products clamped in both ways.
  struct Lifted {
    Tracer<T> together, each;
  };

  GeometryId object_at(int column, int row) {
    if (world_.settings.stage == 1) return no_geometry;
    const std::optional<Nearest> met = tracer_.nearest(world_.lens.ray(column, row, {}));
    return met ? static_cast<GeometryId>(met->id) : no_geometry;
  }

  Light primary(const Ray<T>& ray) {
    if (world_.settings.stage == 1) return Light::all((ray.direction + Vec3<T>(1, 1, 1)) / T(2));
    return color(ray, 0);
  }

  /// The lifts, and what parabolas through three in a row say of those between.
  void include_lifts(Light& light, int column, int row, const SampleOffset& sample) {
    std::vector<Light> all{light};
    for (Lifted& lifted : lifted_) {
      const Vec3<T> together = lifted.together.sample(column, row, sample);
      all.push_back(of_both(together, light.each_value == light.value ? together : lifted.each.sample(column, row, sample)));
      light.include(all.back());
    }
    for (std::size_t i = 2; i < all.size(); ++i) {
      const T middle = (lifts[i - 1] - lifts[i - 2]) / (lifts[i] - lifts[i - 2]);
      const auto extremum = [&](auto value) {
        const Vec3<T>&a = all[i - 2].*value, &b = all[i - 1].*value, &c = all[i].*value;
        return Vec3<T>(between(a.x, b.x, c.x, middle), between(a.y, b.y, c.y, middle), between(a.z, b.z, c.z, middle));
      };
      light.include(of_both(extremum(&Light::value), extremum(&Light::each_value)));
    }
  }

  static Light of_both(const Vec3<T>& together, const Vec3<T>& each) {
    return {together, together, together, each, each, each};
  }

  /// The extremum at 0 < x < 1 of the parabola that is a at 0, b at `middle` and c at 1; a if there is none.
  static T between(const T& a, const T& b, const T& c, const T& middle) {
    const T bend = (c - a - (b - a) / middle) / (1 - middle);
    const T slope = c - a - bend;
    const bool inside = slope * bend < 0 && abs(slope) < 2 * abs(bend);
    return inside ? T(a - slope * slope / (4 * bend)) : a;
  }

  // The recursion, as Tracer's.

  Light color(const Ray<T>& ray, int bounce) {
    const std::optional<Nearest> met = tracer_.nearest(ray);
    note_nearest(ray, met);
    Light light = seen(ray, met, bounce);
    if (bounce > 0)
      for (const std::optional<Nearest>& other : met_after_shifts(ray, met)) {
        const bool watching = std::exchange(watching_, false);
        light.include(seen(ray, other, bounce));
        watching_ = watching;
      }
    return light;
  }

  Light seen(const Ray<T>& ray, const std::optional<Nearest>& met, int bounce) {
    if (!met) return Light::all(Vec3<T>(world_.scene.background));
    const Hit<T> hit = tracer_.hit_at(ray, *met);
    if (world_.settings.stage == 2) return Light::all(Vec3<T>(*tracer_.object_of(hit).color));
    if (tracer_.is_glass(hit)) note(tracer_.far_cosine_squared(ray, hit));
    Light sum = tracer_.is_glass(hit) ? Light{} : lit(ray, hit);
    if (bounce == world_.settings.max_bounces) return sum;
    for (const Branch<T>& branch : tracer_.branches(ray, hit)) {
      const auto weighted = [&](const Vec3<T>& c) { return branch.weight * c; };
      sum += Light::map(weighted, color(branch.ray, bounce + 1));
    }
    return sum;
  }

  Light lit(const Ray<T>& ray, const Hit<T>& hit) {
    const Material& material = *tracer_.object_of(hit).material;
    const bool jumps_at_terminator = material.shininess > 0 && !std::isinf(material.shininess);
    Spread<T> sum = Spread<T>::all(tracer_.ambient());
    for (const Lamp<T>& lamp : tracer_.lamps(hit)) {
      if (jumps_at_terminator) note(dot(lamp.L, hit.normal));
      const T term = tracer_.from_light(ray, hit, lamp);
      const Reach reach = Tracer<T>::above(lamp, hit) ? reach_of(hit, lamp) : reach_from_below();
      sum.value += T(reach.model * term), sum.each_value += T(reach.each * term);
      sum.least += T(reach.always * term), sum.each_least += T(reach.each_always * term);
      sum.greatest += T(reach.sometimes * term), sum.each_greatest += T(reach.each_sometimes * term);
    }
    const Vec3<T> surface(*tracer_.object_of(hit).color);
    return Spread<T>::map([&](const T& light) { return light * surface; }, sum);
  }

  // Which variants let a light reach a point: 1 or 0.

  struct Reach {
    int model, always, sometimes;
    int each, each_always, each_sometimes;
  };

  /// From below, D9: no light, or its highlight alone. Some ask for a shadow there, and the own geometry casts it.
  Reach reach_from_below() const {
    const int unasked = world_.settings.stage < 4;
    return {0, 0, 0, 1, unasked, 1};
  }

  Reach reach_of(const Hit<T>& hit, const Lamp<T>& lamp) {
    if (world_.settings.stage < 4) return {1, 1, 1, 1, 1, 1};
    const Ray<T> shadow = tracer_.shadow_ray(hit, lamp);
    const bool model = !blocked(shadow, lamp.distance);
    bool always = model, sometimes = model;
    for (const T& shift : shifts(shadow, lamp.distance, T(greatest_shadow_shift))) {
      const bool reaches = (lamp.distance && *lamp.distance <= shift) || !blocked_from(shift, shadow, lamp.distance);
      always = always && reaches;
      sometimes = sometimes || reaches;
    }
    return {model, always, sometimes, model, always, sometimes};
  }

  /// The model's answer, whose slack counts: of one blocker, the best, or of all that do not block, the worst.
  bool blocked(const Ray<T>& shadow, const std::optional<T>& distance) {
    std::optional<T> best;
    T worst(1);
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      if (world_.objects[id].material->transparent) continue;
      const bool blocks = tracer_.blocks(id, shadow, distance);
      if (!watching_) {
        if (blocks) return true;
        continue;
      }
      const T here = slack(shadow, id, distance);
      if (blocks)
        best = std::max(best.value_or(T(0)), here);
      else
        worst = std::min(worst, here);
    }
    note(best.value_or(worst));
    return best.has_value();
  }

  bool blocked_from(const T& shift, const Ray<T>& shadow, const std::optional<T>& distance) const {
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      if (world_.objects[id].material->transparent) continue;
      const std::optional<T> t = first_from(shift, roots(shadow, id));
      if (t && (!distance || *t < *distance)) return true;
    }
    return false;
  }

  // Shifts.

  /// Where a ray's line meets a geometry, that which it leaves too.
  struct Roots {
    int count = 0;
    T first, second;
  };

  Roots roots(const Ray<T>& ray, std::size_t id) const {
    const auto& shape = world_.shapes[id];
    const bool own = ray.leaves.geometry == static_cast<GeometryId>(id);
    if (world_.objects[id].plane) {
      const T slope = dot(ray.direction, shape.normal);
      if (own || sign(slope, T(1)) == 0) return {};
      return {1, dot(shape.point - ray.origin, shape.normal) / slope, {}};
    }
    if (own) return {1, -2 * dot(ray.origin - shape.point, ray.direction), {}};  // and 0, before every shift
    const Chord<T> chord(ray, shape.point, shape.radius);
    if (!chord.exists()) return {};
    const T half = chord.half();
    return {2, -chord.b - half, -chord.b + half};
  }

  static std::optional<T> first_from(const T& shift, const Roots& roots) {
    if (roots.count > 0 && roots.first >= shift) return roots.first;
    if (roots.count > 1 && roots.second >= shift) return roots.second;
    return std::nullopt;
  }

  /// One shift of each interval up to `greatest` on which all give the same; none if all give what the model does.
  std::vector<T> shifts(const Ray<T>& ray, const std::optional<T>& distance, const T& greatest) const {
    std::vector<T> all;
    bool differ = false;
    const auto stop_at = [&](const T& t) {
      if (t < 0 || t > greatest) return;
      differ = true;
      if (t > 0) all.push_back(t);
    };
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      const Roots met = roots(ray, id);
      if (met.count > 0) stop_at(met.first);
      if (met.count > 1) stop_at(met.second);
    }
    if (distance) stop_at(*distance);
    if (differ) all.push_back(greatest);
    return all;
  }

  /// What a bounced ray meets under shifts, where that is not what it meets in the model.
  std::vector<std::optional<Nearest>> met_after_shifts(const Ray<T>& ray, const std::optional<Nearest>& model) const {
    std::vector<std::optional<Nearest>> others;
    const auto same = [](const std::optional<Nearest>& a, const std::optional<Nearest>& b) {
      return a.has_value() == b.has_value() && (!a || (a->id == b->id && abs(a->t - b->t) < greatest_bounce_shift / 1e9));
    };
    for (const T& shift : shifts(ray, std::nullopt, T(greatest_bounce_shift))) {
      std::optional<Nearest> best;
      for (std::size_t id = 0; id < world_.objects.size(); ++id)
        if (const std::optional<T> t = first_from(shift, roots(ray, id)); t && (!best || *t < best->t)) best = {id, *t};
      const auto known = [&](const std::optional<Nearest>& other) { return same(best, other); };
      if (!known(model) && std::none_of(others.begin(), others.end(), known)) others.push_back(best);
    }
    return others;
  }

  // The margin: docs/tolerance.md lists these slacks.

  void note(const T& slack) {
    if (watching_) margin_ = std::min(margin_, T(abs(slack)));
  }

  void note_nearest(const Ray<T>& ray, const std::optional<Nearest>& met) {
    if (!watching_) return;
    std::optional<T> limit;
    if (met) {
      limit = met->t;
      note(dot(ray.direction, tracer_.hit_at(ray, *met).normal));
    }
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      const bool winner = met && met->id == id;
      note(slack(ray, id, winner ? std::nullopt : limit));
    }
  }

  /// How far geometry number `id` is from changing whether it is met at a t below the limit (none: at any t); where two
  /// things must happen for that, the farther of them.
  T slack(const Ray<T>& ray, std::size_t id, const std::optional<T>& limit) const {
    const bool own = ray.leaves.geometry == static_cast<GeometryId>(id);
    const bool plane = world_.objects[id].plane != nullptr;
    if (own && (plane || ray.leaves.side == Side::outwards)) return T(1);
    if (plane) return plane_slack(ray, world_.shapes[id], limit);
    if (own) return to_limit(T(-2 * dot(ray.origin - world_.shapes[id].point, ray.direction)), limit);
    return sphere_slack(ray, world_.shapes[id], limit);
  }

  using Shape = typename World<T>::Shape;

  static T to_limit(const T& t, const std::optional<T>& limit) {
    return limit ? T(abs(t - *limit) / std::max(std::max(t, *limit), T(1))) : T(1);
  }

  /// Distances near 0 are to be seen beside the coordinates that they come from.
  static T to_origin(const T& t, const Ray<T>& ray) { return abs(t) / std::max(size(ray.origin), T(1)); }

  static T plane_slack(const Ray<T>& ray, const Shape& plane, const std::optional<T>& limit) {
    const T slope = dot(ray.direction, plane.normal);
    const T height = dot(plane.point - ray.origin, plane.normal);
    if (slope == 0) return limit ? T(abs(height) / *limit) : T(0);
    const T t = height / slope;
    const T start = to_origin(t, ray);
    if (t >= 0) return limit && t >= *limit ? to_limit(t, limit) : std::min({start, to_limit(t, limit), T(abs(slope))});
    // Behind: met if the origin moves past it, or if the ray turns so far that it meets it before the limit.
    return std::min(start, T(abs(slope) + (limit && *limit > 0 ? T(abs(height) / *limit) : T(0))));
  }

  static T sphere_slack(const Ray<T>& ray, const Shape& sphere, const std::optional<T>& limit) {
    const Chord<T> chord(ray, sphere.point, sphere.radius);
    const T tangent = abs(chord.discriminant()) / (sphere.radius * sphere.radius);
    if (!chord.exists()) {
      const T behind = chord.b > 0 ? to_origin(chord.b, ray) : T(0);
      const T beyond = limit && -chord.b > *limit ? to_limit(T(-chord.b), limit) : T(0);
      return std::max({tangent, behind, beyond});
    }
    const T first = -chord.b - chord.half();
    const T second = -chord.b + chord.half();
    if (second < 0) return to_origin(second, ray);
    if (first < 0) return std::min({to_origin(first, ray), to_origin(second, ray), to_limit(second, limit)});
    const bool met = !limit || first < *limit;
    return met ? std::min({tangent, to_origin(first, ray), to_limit(first, limit)}) : to_limit(first, limit);
  }

  const World<T>& world_;
  RayCounts uncounted_;
  Tracer<T> tracer_;
  std::vector<Lifted> lifted_;
  bool watching_ = true;  ///< off where a variant is followed, whose decisions are not the model's
  T margin_ = T(1);
};

}  // namespace raylab::oracle
