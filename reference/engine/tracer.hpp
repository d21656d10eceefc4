#pragma once

#include "reference/engine/glass.hpp"
#include "reference/engine/intersect.hpp"
#include "reference/engine/prepared.hpp"
#include "reference/engine/shade.hpp"

#include <atomic>
#include <limits>
#include <vector>

namespace raylab::fast {

template <class T>
struct Ray {
  Vec3<T> origin;
  Vec3<T> direction;  ///< unit
  Leaves leaves;      ///< says whether the ray may meet its own surface again: no epsilon anywhere (D6)
};

/// The nearest surface that a ray meets.
template <class T>
struct Hit {
  T t = std::numeric_limits<T>::infinity();
  GeometryId geometry = no_geometry;
  Side side = Side::outwards;
  Vec3<T> point;
  Vec3<T> normal;  ///< unit, turned to the ray's side
};

/// Follows the rays of one pixel after the other through a prepared scene. One for each call of trace_rows: it holds the
/// rays that wait, the counts, and nothing that one pixel could pass on to the next.
template <class T>
class Tracer {
 public:
  Tracer(const Prepared<T>& scene, RayCounts& counts, const std::atomic<bool>& cancel)
      : scene_(scene), counts_(counts), cancel_(cancel) {
    waiting_.reserve(static_cast<std::size_t>(scene.settings.max_bounces) + 2);
  }

  /// The mean of the pixel's samples, not yet clamped.
  Color pixel(int column, int row) {
    Color sum(0);
    for (const SampleOffset& sample : scene_.samples) {
      const Vec3<T> color = primary(column, row, sample);
      sum += Color(color.x, color.y, color.z);
    }
    return sum / static_cast<double>(scene_.samples.size());
  }

 private:
  /// A ray to be traced, and how much of its color reaches the pixel.
  struct Waiting {
    Ray<T> ray;
    T weight;
    int bounce;
  };

  Vec3<T> primary(int column, int row, const SampleOffset& sample) {
    ++counts_.primary;
    const PreparedCamera<T>& camera = scene_.camera;
    const T x = static_cast<T>(column + 0.5 - 0.5 * scene_.settings.size.width + sample.dx);
    const T y = static_cast<T>(0.5 * scene_.settings.size.height - row - 0.5 + sample.dy);
    const Vec3<T> d = unit(camera.forward + x * camera.right + y * camera.up);
    if (scene_.settings.stage == 1) return T(0.5) * (d + Vec3<T>{1, 1, 1});
    return color({camera.position, d, {}});
  }

  /// The color at the end of a primary ray. Glass splits a ray in two: those to come wait on a stack, which never holds
  /// more than one ray for each bounce.
  Vec3<T> color(const Ray<T>& primary_ray) {
    Vec3<T> sum;
    waiting_.push_back({primary_ray, T(1), 0});
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      sum += next.weight * surface_color(next);
    }
    return sum;
  }

  /// The color that the nearest surface itself sends back; the rays that it sends on are added to those that wait.
  Vec3<T> surface_color(const Waiting& from) {
    if (cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
    const Hit<T> hit = nearest(from.ray);
    if (hit.geometry == no_geometry) return scene_.background;
    const std::size_t id = static_cast<std::size_t>(hit.geometry);
    if (scene_.settings.stage == 2) return scene_.colors[id];
    const Finish<T>& finish = scene_.finishes[scene_.finish_of[id]];
    if (finish.glass) {
      send_through_glass(from, hit, finish);
      return {};
    }
    if (finish.mirror > 0) send_reflected(from, hit, finish.mirror);
    return tinted(light_on(hit, from.ray.direction, finish), scene_.colors[id]);
  }

  // ---- Intersections ------------------------------------------------------------------------------------------------

  Hit<T> nearest(const Ray<T>& ray) {
    Hit<T> best;
    nearest_plane(ray, best);
    nearest_sphere(ray, best);
    if (best.geometry != no_geometry) best.point = ray.origin + best.t * ray.direction;
    return best;
  }

  void nearest_plane(const Ray<T>& ray, Hit<T>& best) const {
    const Planes<T>& planes = scene_.planes;
    const std::size_t own = plane_place(ray.leaves.geometry);
    for (std::size_t i = 0; i < planes.point.size(); ++i) {
      const T t = plane_distance(ray.origin, ray.direction, planes.point[i], planes.normal[i]);
      if (!(t >= 0 && t < best.t) || i == own) continue;
      best.t = t;
      best.geometry = static_cast<GeometryId>(i);
    }
    if (best.geometry == no_geometry) return;
    const Vec3<T> normal = planes.normal[static_cast<std::size_t>(best.geometry)];
    best.normal = dot(normal, ray.direction) > 0 ? -normal : normal;
  }

  void nearest_sphere(const Ray<T>& ray, Hit<T>& best) {
    const Spheres<T>& spheres = scene_.spheres;
    const std::size_t own = sphere_place(ray.leaves.geometry);
    SphereMeeting<T> winner{};
    std::size_t place = nowhere;
    const auto consider = [&](const SphereMeeting<T>& meeting, std::size_t i) {
      if (!(meeting.t < best.t || (meeting.t == best.t && i < place && place != nowhere))) return;
      best.t = meeting.t;
      winner = meeting;
      place = i;
    };
    if (own < spheres.radius.size() && ray.leaves.side == Side::inwards)
      consider(meet_far_side(ray.origin, ray.direction, spheres.center[own]), own);
    for (std::size_t i = 0; i < spheres.radius.size(); ++i) {
      poll(i);
      if (i == own || !may_meet_sphere(ray.origin, ray.direction, spheres.center[i], spheres.radius[i], best.t)) continue;
      const auto meeting = meet_sphere(ray.origin, ray.direction, spheres.center[i], spheres.radius[i]);
      if (meeting) consider(*meeting, i);
    }
    if (place == nowhere) return;
    best.geometry = static_cast<GeometryId>(place + scene_.planes.point.size());
    best.side = winner.inside ? Side::inwards : Side::outwards;
    best.normal = unit(winner.inside ? -winner.outwards : winner.outwards);
  }

  /// The place of a geometry in the list of its kind, planes or spheres; far beyond its end for one of the other kind.
  std::size_t plane_place(GeometryId id) const { return static_cast<std::size_t>(id); }
  std::size_t sphere_place(GeometryId id) const { return static_cast<std::size_t>(id) - scene_.planes.point.size(); }

  /// A row of a million spheres must not keep anybody waiting.
  void poll(std::size_t i) const {
    if (i % 4096 == 4095 && cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
  }

  // ---- Light --------------------------------------------------------------------------------------------------------

  /// All the light that a surface sends back against `d`, but for the surface's color.
  T light_on(const Hit<T>& hit, const Vec3<T>& d, const Finish<T>& finish) {
    T sum = scene_.ambient;
    for (const PreparedPointLight<T>& light : scene_.point_lights) {
      const Vec3<T> way = light.position - hit.point;
      const T r = length(way);
      if (r == 0) continue;
      sum += light_from({way / r, r, light.sides}, hit, d, finish) * (light.intensity / ((1 + r) * (1 + r)));
    }
    for (const PreparedDirectionalLight<T>& light : scene_.directional_lights)
      sum += light_from({light.l, std::numeric_limits<T>::infinity(), light.sides}, hit, d, finish) * light.intensity;
    return sum;
  }

  /// A light as a point sees it.
  struct Seen {
    Vec3<T> l;  ///< unit, towards the light
    T distance;
    const Sides& sides;
  };

  T light_from(const Seen& light, const Hit<T>& hit, const Vec3<T>& d, const Finish<T>& finish) {
    const T cosine = dot(light.l, hit.normal);
    if (!(cosine > 0) || in_own_plane(hit, light.sides)) return 0;
    if (scene_.settings.stage >= 4 && blocked(hit, light)) return 0;
    return blinn_phong(light.l, cosine, hit.normal, -d, finish);
  }

  /// Is the light in the very plane that it would light? The rounded cosine is not 0 then, and may be above it.
  bool in_own_plane(const Hit<T>& hit, const Sides& sides) const {
    const std::size_t place = plane_place(hit.geometry);
    return place < sides.size() && sides[place] == 0;
  }

  bool blocked(const Hit<T>& hit, const Seen& light) {
    ++counts_.shadow;
    const Ray<T> shadow{hit.point, light.l, {hit.geometry, hit.side}};
    return blocked_by_plane(hit, light.sides) || blocked_by_sphere(shadow, light.distance);
  }

  bool blocked_by_plane(const Hit<T>& hit, const Sides& sides) const {
    const Planes<T>& planes = scene_.planes;
    const std::size_t own = plane_place(hit.geometry);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const T side = static_cast<T>(sides[i]);
      if (side != 0 && side * dot(planes.point[i] - hit.point, planes.normal[i]) <= 0 && i != own) return true;
    }
    return false;
  }

  bool blocked_by_sphere(const Ray<T>& shadow, T distance) const {
    const Spheres<T>& spheres = scene_.spheres;
    const std::size_t own = sphere_place(shadow.leaves.geometry);
    const auto blocks = [&](std::size_t i) {
      const Vec3<T> center = spheres.center[i];
      if (i == own)
        return shadow.leaves.side == Side::inwards && meet_far_side(shadow.origin, shadow.direction, center).t < distance;
      if (!may_meet_sphere(shadow.origin, shadow.direction, center, spheres.radius[i], distance)) return false;
      const auto meeting = meet_sphere(shadow.origin, shadow.direction, center, spheres.radius[i]);
      return meeting && meeting->t < distance;
    };
    for (const Run& run : spheres.opaque)
      for (std::size_t i = run.begin; i < run.end; ++i) {
        poll(i);
        if (blocks(i)) return true;
      }
    return false;
  }

  // ---- Bounces ------------------------------------------------------------------------------------------------------

  void send(const Waiting& from, const Ray<T>& ray, T weight, std::uint64_t& count) {
    const T reaches_pixel = from.weight * weight;
    if (from.bounce >= scene_.settings.max_bounces || !(reaches_pixel > 0)) return;
    ++count;
    waiting_.push_back({ray, reaches_pixel, from.bounce + 1});
  }

  void send_reflected(const Waiting& from, const Hit<T>& hit, T weight) {
    const Ray<T> ray{hit.point, reflected(from.ray.direction, hit.normal), {hit.geometry, hit.side}};
    send(from, ray, weight, counts_.reflected);
  }

  void send_through_glass(const Waiting& from, const Hit<T>& hit, const Finish<T>& glass) {
    const Vec3<T>& d = from.ray.direction;
    const bool outside = hit.side == Side::outwards;
    const auto refraction = outside ? Refraction<T>::from_outside(d, hit.normal, glass)  //
                                    : Refraction<T>::from_inside(d, hit.normal, glass);
    const Parts<T> parts = refraction.total ? Parts<T>{1, 0} : schlick(outside ? refraction.cosine : refraction.q, glass);
    send_reflected(from, hit, parts.reflected);
    if (!(parts.refracted > 0)) return;
    const std::size_t place = sphere_place(hit.geometry);
    const Refracted<T> ahead = outside ? through_sphere(refraction, d, hit.normal, scene_.spheres.center[place],
                                                        scene_.spheres.radius[place], glass)
                                       : out_of_sphere(refraction, d, hit.normal, hit.point, glass);
    send(from, {ahead.origin, ahead.direction, {hit.geometry, Side::outwards}}, parts.refracted, counts_.refracted);
  }

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  const Prepared<T>& scene_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  std::vector<Waiting> waiting_;
};

}  // namespace raylab::fast
