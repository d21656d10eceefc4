#pragma once

// How docs/model.md's formulas (formulas.hpp) work together, in its order.
#include "core/render/engine.hpp"
#include "reference/oracle/formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace raylab::oracle {

/// One geometry of the scene, whose GeometryId is its place in the list of all: planes, spheres, clouds, in file order.
struct Object {
  const raylab::Plane* plane;    ///< null for a sphere
  const raylab::Sphere* sphere;  ///< null for a plane
  const Material* material;
  const Color* color;  ///< the material's, or that of a cloud's table
};

std::vector<Object> all_objects(const Scene& scene);

/// The scene at one precision.
template <class T>
struct World {
  /// What formulas ask of a geometry.
  struct Shape {
    Vec3<T> point;   ///< of a plane, or a sphere's center
    Vec3<T> normal;  ///< a plane's: unit
    T radius;        ///< a sphere's
  };

  const Scene& scene;
  const std::vector<Object>& objects;
  const Settings& settings;
  Lens<T> lens;
  std::vector<Shape> shapes;            ///< of the objects
  std::vector<Vec3<T>> to_directional;  ///< L of each directional light
  std::map<double, T> k_s;              ///< of each shininess in the scene

  World(const Scene& scene_, const std::vector<Object>& objects_, const Settings& settings_)
      : scene(scene_), objects(objects_), settings(settings_), lens(scene.camera, settings.size) {
    for (const Object& object : objects) {
      if (object.plane)
        shapes.push_back({Vec3<T>(object.plane->point), unit(Vec3<T>(object.plane->normal)), T(0)});
      else
        shapes.push_back({Vec3<T>(object.sphere->center), {}, T(object.sphere->radius)});
      k_s.try_emplace(object.material->shininess, specular_weight<T>(object.material->shininess));
    }
    for (const DirectionalLight& light : scene.directional_lights) to_directional.push_back(-unit(Vec3<T>(light.direction)));
  }
};

template <class T>
struct Hit {
  GeometryId geometry;
  Vec3<T> point;   ///< p
  Vec3<T> normal;  ///< N: unit, d.N <= 0
  Side side;       ///< on which the ray came, and on which a ray that stays there leaves
};

/// A ray that a surface sends on, and how much of its color the surface takes.
template <class T>
struct Branch {
  Ray<T> ray;
  T weight;
  bool refracted;
};

/// Follows rays, counts them, and gives up with Cancelled when asked to.
template <class T>
class Tracer {
 public:
  /// What becomes of each ray, the camera's, the bounced and the shadow rays, before it is followed, and of the point where
  /// it ends, from which others start.
  using Alter = Ray<T> (*)(const Ray<T>& ray, std::uint64_t number);
  static Ray<T> unaltered(const Ray<T>& ray, std::uint64_t) { return ray; }

  /// clamp_each: each dot product clamped by itself, an accepted variant of D9. lift: how far along the normal
  /// reflected and exit rays start off the surface, another.
  Tracer(const World<T>& world, RayCounts& counts, const std::atomic<bool>& cancel, bool clamp_each = false,
         Alter alter = unaltered, const T& lift = T(0))
      : world_(world), counts_(counts), cancel_(cancel), clamp_each_(clamp_each), alter_(alter), lift_(lift) {}

  /// 7 SSAA: the mean of the samples, then the clamp (D18).
  Vec3<T> pixel(int column, int row, const std::vector<SampleOffset>& samples) {
    Vec3<T> sum;
    for (const SampleOffset& offset : samples) sum += sample(column, row, offset);
    return clamped(sum / T(samples.size()));
  }

  /// One of them, not clamped.
  Vec3<T> sample(int column, int row, const SampleOffset& offset) {
    return primary(altered(world_.lens.ray(column, row, offset)));
  }

  // 2 Intersections

  /// The distance to geometry number `id`, with regard to what the ray leaves (D6).
  std::optional<T> meet(const Ray<T>& ray, std::size_t id) {
    if (++asked_ % 256 == 0 && cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
    const bool plane = world_.objects[id].plane != nullptr;
    const bool own = ray.leaves.geometry == static_cast<GeometryId>(id);
    if (own && (plane || ray.leaves.side == Side::outwards)) return std::nullopt;
    const auto& shape = world_.shapes[id];
    if (plane) return meet_plane(ray, shape.point, shape.normal);
    if (own && lift_ == 0) return meet_far_side(ray, shape.point);
    return meet_sphere(ray, shape.point, shape.radius);
  }

  struct Nearest {
    std::size_t id;
    T t;
  };

  /// Of equal distances the first in the list counts (D7).
  std::optional<Nearest> nearest(const Ray<T>& ray) {
    std::optional<Nearest> best;
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      const std::optional<T> t = meet(ray, id);
      if (t && (!best || sign(T(best->t - *t), T(best->t + size(ray.origin))) > 0)) best = {id, *t};
    }
    return best;
  }

  /// D8.
  Hit<T> hit_at(const Ray<T>& ray, const Nearest& met) {
    const auto& shape = world_.shapes[met.id];
    const bool plane = world_.objects[met.id].plane != nullptr;
    const GeometryId id = static_cast<GeometryId>(met.id);
    const Vec3<T> p = altered({ray.origin + met.t * ray.direction, ray.direction, {id, Side::outwards}}).origin;
    const Vec3<T> outwards = plane ? shape.normal : unit(p - shape.point);
    const bool turned = sign(dot(ray.direction, outwards), T(1)) > 0;
    const Side side = turned && !plane ? Side::inwards : Side::outwards;
    return {id, p, turned ? -outwards : outwards, side};
  }

  const Object& object_of(const Hit<T>& hit) const { return world_.objects[static_cast<std::size_t>(hit.geometry)]; }

  const T& k_s_of(const Object& object) const { return world_.k_s.at(object.material->shininess); }

  // 3 Blinn-Phong

  T ambient() const {
    T sum(0);
    for (const AmbientLight& light : world_.scene.ambient_lights) sum += light.intensity;
    return sum;
  }

  /// The lights that are not ambient, but one at p itself.
  std::vector<Lamp<T>> lamps(const Hit<T>& hit) const {
    std::vector<Lamp<T>> all;
    for (const PointLight& light : world_.scene.point_lights)
      if (const std::optional<Lamp<T>> lamp = lamp_at(light, hit.point)) all.push_back(*lamp);
    for (std::size_t i = 0; i < world_.to_directional.size(); ++i)
      all.push_back({world_.to_directional[i], std::nullopt, T(world_.scene.directional_lights[i].intensity)});
    return all;
  }

  /// Only then a shadow ray is sent.
  static bool above(const Lamp<T>& lamp, const Hit<T>& hit) { return oracle::above(lamp, hit.normal); }

  T from_light(const Ray<T>& ray, const Hit<T>& hit, const Lamp<T>& lamp) const {
    const Object& object = object_of(hit);
    return oracle::from_light(lamp, hit.normal, -ray.direction, k_s_of(object), object.material->shininess);
  }

  // 4 Shadows

  Ray<T> shadow_ray(const Hit<T>& hit, const Lamp<T>& lamp) {
    return altered({hit.point, lamp.L, {hit.geometry, hit.side}});
  }

  /// Does opaque geometry number `id` meet a shadow ray at 0 <= t < distance? (D12)
  bool blocks(std::size_t id, const Ray<T>& shadow, const std::optional<T>& distance) {
    if (world_.objects[id].material->transparent) return false;
    const std::optional<T> t = meet(shadow, id);
    return t && (!distance || sign(T(*distance - *t), T(*distance + size(shadow.origin))) > 0);
  }

  // 5 Reflections, 6 Refraction

  bool is_glass(const Hit<T>& hit) const { return world_.settings.stage >= 6 && object_of(hit).material->transparent; }

  /// The rays that the surface sends on, none of weight 0.
  std::vector<Branch<T>> branches(const Ray<T>& ray, const Hit<T>& hit) {
    if (is_glass(hit)) return glass(ray, hit);
    const Object& object = object_of(hit);
    if (world_.settings.stage < 5 || !(object.material->shininess > 0)) return {};
    return {{mirrored(ray, hit), k_s_of(object), false}};
  }

  /// The square of the cosine on the far side of glass, by Snell's law; below 0 at total reflection.
  T far_cosine_squared(const Ray<T>& ray, const Hit<T>& hit) const {
    const T n(object_of(hit).material->refractive_index);
    return refracted_cosine_squared(T(-dot(ray.direction, hit.normal)), snell_ratio(hit.side, n));
  }

 private:
  Ray<T> altered(const Ray<T>& ray) { return alter_(ray, made_++); }

  Vec3<T> primary(const Ray<T>& ray) {
    ++counts_.primary;
    if (world_.settings.stage == 1) return (ray.direction + Vec3<T>(1, 1, 1)) / T(2);  // D5
    return color(ray, 0);
  }

  /// A ray of a bounce beyond the limit is black (D14).
  Vec3<T> color(const Ray<T>& ray, int bounce) {
    const std::optional<Nearest> met = nearest(ray);
    if (!met) return Vec3<T>(world_.scene.background);
    const Hit<T> hit = hit_at(ray, *met);
    if (world_.settings.stage == 2) return Vec3<T>(*object_of(hit).color);
    Vec3<T> sum = is_glass(hit) ? Vec3<T>() : lit(ray, hit);
    if (bounce == world_.settings.max_bounces) return sum;
    for (const Branch<T>& branch : branches(ray, hit)) {
      ++(branch.refracted ? counts_.refracted : counts_.reflected);
      sum += branch.weight * color(branch.ray, bounce + 1);
    }
    return sum;
  }

  Vec3<T> lit(const Ray<T>& ray, const Hit<T>& hit) {
    T sum = ambient();
    for (const Lamp<T>& lamp : lamps(hit)) {
      const bool reaches = above(lamp, hit) ? world_.settings.stage < 4 || !blocked(hit, lamp) : clamp_each_;
      if (reaches) sum += from_light(ray, hit, lamp);
    }
    return sum * Vec3<T>(*object_of(hit).color);
  }

  bool blocked(const Hit<T>& hit, const Lamp<T>& lamp) {
    ++counts_.shadow;
    const Ray<T> shadow = shadow_ray(hit, lamp);
    for (std::size_t id = 0; id < world_.objects.size(); ++id)
      if (blocks(id, shadow, lamp.distance)) return true;
    return false;
  }

  Ray<T> mirrored(const Ray<T>& ray, const Hit<T>& hit) {
    return altered({hit.point + lift_ * hit.normal, reflect(ray.direction, hit.normal), {hit.geometry, hit.side}});
  }

  /// R of the reflected ray and 1 - R of the refracted one, met from outside or from inside (D17).
  std::vector<Branch<T>> glass(const Ray<T>& ray, const Hit<T>& hit) {
    const T n(object_of(hit).material->refractive_index);
    const bool outside = hit.side == Side::outwards;
    const auto [ratio, cos_far, R] = split_at_glass(T(-dot(ray.direction, hit.normal)), hit.side, n);
    std::vector<Branch<T>> both;
    if (R > 0) both.push_back({mirrored(ray, hit), R, false});
    if (R < 1) {
      Ray<T> ahead = altered({hit.point,
                              refract(ray.direction, hit.normal, ratio, *cos_far),
                              {hit.geometry, outside ? Side::inwards : Side::outwards}});
      const Vec3<T>& c = world_.shapes[static_cast<std::size_t>(hit.geometry)].point;
      if (outside) ahead = altered(exit_ray(ahead, c, n));
      if (lift_ > 0) ahead.origin += lift_ * unit(ahead.origin - c);
      both.push_back({ahead, T(1 - R), true});
    }
    return both;
  }

  const World<T>& world_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  const bool clamp_each_;
  const Alter alter_;
  const T lift_;
  std::uint64_t asked_ = 0;  ///< geometries so far
  std::uint64_t made_ = 0;   ///< rays so far
};

}  // namespace raylab::oracle
