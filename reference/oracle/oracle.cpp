// The truth: how docs/model.md's formulas (formulas.hpp) work together, in its order.
#include "reference/oracle/oracle.hpp"

#include "reference/oracle/formulas.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace raylab {
namespace oracle {
namespace {

/// One geometry of the scene, whose GeometryId is its place in the list of all: planes, spheres, clouds, in file order.
struct Object {
  const raylab::Plane* plane;    ///< null for a sphere
  const raylab::Sphere* sphere;  ///< null for a plane
  const Material* material;
  const Color* color;  ///< the material's, or that of a cloud's table
};

std::vector<Object> all_objects(const Scene& scene) {
  std::vector<Object> objects;
  objects.reserve(geometry_count(scene));
  for (const PlaneObject& plane : scene.planes)
    objects.push_back({&plane.shape, nullptr, &plane.material, &plane.material.color});
  for (const SphereObject& sphere : scene.spheres)
    objects.push_back({nullptr, &sphere.shape, &sphere.material, &sphere.material.color});
  for (const SphereCloud& cloud : scene.clouds)
    for (std::size_t i = 0; i < cloud.spheres.size(); ++i)
      objects.push_back(
          {nullptr, &cloud.spheres[i], &cloud.material, cloud.colors.empty() ? &cloud.material.color : &cloud.colors[i]});
  return objects;
}

template <class T>
struct Hit {
  GeometryId geometry;
  Vec3<T> point;   ///< p
  Vec3<T> normal;  ///< N: unit, d.N <= 0
  Side side;       ///< on which the ray came, and on which a ray that stays there leaves
};

// ---- The ray's way through the scene --------------------------------------------------------------------------------

/// The scene at one precision.
template <class T>
struct World {
  const Scene& scene;
  const std::vector<Object>& objects;
  const Settings& settings;
  Lens<T> lens;
  std::vector<Vec3<T>> plane_normals;   ///< unit, one for each plane
  std::vector<Vec3<T>> to_directional;  ///< L of each directional light
  std::map<double, T> k_s;              ///< of each shininess in the scene

  World(const Scene& scene_, const std::vector<Object>& objects_, const Settings& settings_)
      : scene(scene_), objects(objects_), settings(settings_), lens(scene.camera, settings.size) {
    for (const PlaneObject& plane : scene.planes) plane_normals.push_back(unit(Vec3<T>(plane.shape.normal)));
    for (const DirectionalLight& light : scene.directional_lights) to_directional.push_back(-unit(Vec3<T>(light.direction)));
    for (const PlaneObject& plane : scene.planes) add_k_s(plane.material);
    for (const SphereObject& sphere : scene.spheres) add_k_s(sphere.material);
    for (const SphereCloud& cloud : scene.clouds) add_k_s(cloud.material);
  }

 private:
  void add_k_s(const Material& material) { k_s.try_emplace(material.shininess, specular_weight<T>(material.shininess)); }
};

/// Follows rays, counts them, and gives up with Cancelled when asked to.
template <class T>
class Tracer {
 public:
  Tracer(const World<T>& world, RayCounts& counts, const std::atomic<bool>& cancel)
      : world_(world), counts_(counts), cancel_(cancel) {}

  /// 7 SSAA: the mean of the samples, then the clamp (D18).
  Vec3<T> pixel(int column, int row, const std::vector<SampleOffset>& samples) {
    Vec3<T> sum;
    for (const SampleOffset& sample : samples) sum += primary(world_.lens.ray(column, row, sample));
    const auto resolve = [&](const T& total) { return std::clamp(T(total / samples.size()), T(0), T(1)); };
    return {resolve(sum.x), resolve(sum.y), resolve(sum.z)};
  }

 private:
  Vec3<T> primary(const Ray<T>& ray) {
    ++counts_.primary;
    if (world_.settings.stage == 1) return (ray.direction + Vec3<T>(1, 1, 1)) / T(2);  // D5
    return color(ray, 0);
  }

  Vec3<T> color(const Ray<T>& ray, int bounce) {
    const std::optional<Hit<T>> hit = nearest(ray);
    if (!hit) return Vec3<T>(world_.scene.background);
    const Object& object = object_of(*hit);
    const int stage = world_.settings.stage;
    if (stage == 2) return Vec3<T>(*object.color);
    if (stage >= 6 && object.material->transparent) return glass(ray, *hit, bounce);
    Vec3<T> sum = lit(ray, *hit);
    if (stage >= 5 && object.material->shininess > 0)
      sum += k_s_of(object) * bounced(mirrored(ray, *hit), bounce, counts_.reflected);
    return sum;
  }

  const Object& object_of(const Hit<T>& hit) const { return world_.objects[static_cast<std::size_t>(hit.geometry)]; }

  const T& k_s_of(const Object& object) const { return world_.k_s.at(object.material->shininess); }

  // 2 Intersections

  /// The distance to geometry number `id`, with regard to what the ray leaves (D6).
  std::optional<T> meet(const Ray<T>& ray, std::size_t id) {
    if (++asked_ % 256 == 0 && cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
    const Object& object = world_.objects[id];
    const bool own = ray.leaves.geometry == static_cast<GeometryId>(id);
    if (own && (object.plane || ray.leaves.side == Side::outwards)) return std::nullopt;
    if (object.plane) return meet_plane(ray, Vec3<T>(object.plane->point), world_.plane_normals[id]);
    const Vec3<T> center(object.sphere->center);
    if (own) return std::max(T(0), T(-2 * dot(ray.origin - center, ray.direction)));
    return meet_sphere(ray, center, T(object.sphere->radius));
  }

  /// Of equal distances the first in the list counts (D7).
  std::optional<Hit<T>> nearest(const Ray<T>& ray) {
    std::optional<T> least;
    std::size_t winner = 0;
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      const std::optional<T> t = meet(ray, id);
      if (!t || (least && sign(T(*least - *t), T(*least + size(ray.origin))) <= 0)) continue;
      least = t;
      winner = id;
    }
    if (!least) return std::nullopt;
    return hit_at(ray, winner, *least);
  }

  /// D8.
  Hit<T> hit_at(const Ray<T>& ray, std::size_t id, const T& t) const {
    const Object& object = world_.objects[id];
    const Vec3<T> p = ray.origin + t * ray.direction;
    const Vec3<T> outwards = object.plane ? world_.plane_normals[id] : unit(p - Vec3<T>(object.sphere->center));
    const bool turned = sign(dot(ray.direction, outwards), T(1)) > 0;
    const Side side = turned && object.sphere ? Side::inwards : Side::outwards;
    return {static_cast<GeometryId>(id), p, turned ? -outwards : outwards, side};
  }

  // 3 Blinn-Phong

  /// What the surface sends back along the ray from all lights.
  Vec3<T> lit(const Ray<T>& ray, const Hit<T>& hit) {
    T sum(0);
    for (const AmbientLight& light : world_.scene.ambient_lights) sum += light.intensity;
    for (const PointLight& light : world_.scene.point_lights) {
      const Vec3<T> position(light.position);
      const T r = length(position - hit.point);
      if (sign(r, T(size(position) + size(hit.point))) == 0) continue;  // a light at p itself
      sum += from_light(ray, hit, (position - hit.point) / r, r) * light.intensity / ((1 + r) * (1 + r));
    }
    for (std::size_t i = 0; i < world_.to_directional.size(); ++i)
      sum += from_light(ray, hit, world_.to_directional[i], std::nullopt) * world_.scene.directional_lights[i].intensity;
    return sum * Vec3<T>(*object_of(hit).color);
  }

  /// The part of a light in direction L that the surface sends back, before the light's strength and the surface's color.
  T from_light(const Ray<T>& ray, const Hit<T>& hit, const Vec3<T>& L, const std::optional<T>& distance) {
    if (sign(dot(L, hit.normal), T(1)) <= 0) return T(0);  // D9
    if (world_.settings.stage >= 4 && blocked(hit, L, distance)) return T(0);
    const Object& object = object_of(hit);
    return blinn_phong(L, hit.normal, -ray.direction, k_s_of(object), object.material->shininess);
  }

  // 4 Shadows

  /// Does an opaque geometry meet the ray from p along L at 0 <= t < distance? No distance means infinity. (D12)
  bool blocked(const Hit<T>& hit, const Vec3<T>& L, const std::optional<T>& distance) {
    ++counts_.shadow;
    const Ray<T> shadow{hit.point, L, {hit.geometry, hit.side}};
    for (std::size_t id = 0; id < world_.objects.size(); ++id) {
      if (world_.objects[id].material->transparent) continue;
      const std::optional<T> t = meet(shadow, id);
      if (t && (!distance || sign(T(*distance - *t), T(*distance + size(hit.point))) > 0)) return true;
    }
    return false;
  }

  // 5 Reflections

  Ray<T> mirrored(const Ray<T>& ray, const Hit<T>& hit) const {
    return {hit.point, reflect(ray.direction, hit.normal), {hit.geometry, hit.side}};
  }

  /// The color at the end of a ray that comes of the ray of bounce number `bounce` (D14).
  Vec3<T> bounced(const Ray<T>& ray, int bounce, std::uint64_t& count) {
    if (bounce + 1 > world_.settings.max_bounces) return {};
    ++count;
    return color(ray, bounce + 1);
  }

  // 6 Refraction

  /// R times the reflected color and 1 - R times the refracted one, met from outside or from inside (D17).
  Vec3<T> glass(const Ray<T>& ray, const Hit<T>& hit, int bounce) {
    const T n(object_of(hit).material->refractive_index);
    const bool outside = hit.side == Side::outwards;
    const T cos_here = -dot(ray.direction, hit.normal);
    const std::optional<T> cos_there = refracted_cosine(cos_here, outside ? T(1 / n) : n);
    const T R = cos_there ? schlick(outside ? cos_here : *cos_there, n) : T(1);  // D16
    Vec3<T> sum;
    if (R > 0) sum += R * bounced(mirrored(ray, hit), bounce, counts_.reflected);
    if (R < 1) {
      const Ray<T> ahead{hit.point,
                         refract(ray.direction, hit.normal, outside ? T(1 / n) : n, *cos_there),
                         {hit.geometry, outside ? Side::inwards : Side::outwards}};
      sum += T(1 - R) * bounced(outside ? beyond(ahead, n) : ahead, bounce, counts_.refracted);
    }
    return sum;
  }

  /// The exit ray of a ray that has just entered glass: out at the second point, whatever else is inside (D15). In exact
  /// arithmetic it leaves at the angle at which it came, so there is always one.
  Ray<T> beyond(const Ray<T>& inside, const T& n) {
    const std::size_t id = static_cast<std::size_t>(inside.leaves.geometry);
    const Vec3<T> second = inside.origin + *meet(inside, id) * inside.direction;
    const Vec3<T> N = unit(Vec3<T>(world_.objects[id].sphere->center) - second);
    const T cos_out = refracted_cosine(T(-dot(inside.direction, N)), n).value_or(T(0));
    return {second, refract(inside.direction, N, n, cos_out), {inside.leaves.geometry, Side::outwards}};
  }

  const World<T>& world_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  std::uint64_t asked_ = 0;  ///< geometries so far
};

// ---- Output ---------------------------------------------------------------------------------------------------------

/// Do both colors say the same, to 1e-25? They are clamped already: what lies beyond white need not be known to as many
/// places.
template <class T, class Finer>
bool agree(const Vec3<T>& coarse, const Vec3<Finer>& fine) {
  static const Finer tolerance("1e-25");
  const auto close = [](const T& a, const Finer& b) { return abs(Finer(a) - b) <= tolerance; };
  return close(coarse.x, fine.x) && close(coarse.y, fine.y) && close(coarse.z, fine.z);
}

template <class T>
Color rounded(const Vec3<T>& color) {
  return {color.x.template convert_to<double>(), color.y.template convert_to<double>(),
          color.z.template convert_to<double>()};
}

std::vector<SampleOffset> samples_of(const Settings& settings) {
  const AntiAliasing by_stage = settings.stage >= 7 ? AntiAliasing::rotated4 : AntiAliasing::none;
  return sample_offsets(settings.aa.value_or(by_stage));
}

class Oracle : public Engine {
 public:
  Oracle(const Scene& scene, const Settings& settings)
      : scene_(scene), settings_(settings), objects_(all_objects(scene_)), samples_(samples_of(settings)) {}

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    const std::size_t width = static_cast<std::size_t>(settings_.size.width);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (cancel.load(std::memory_order_relaxed)) throw Cancelled{};
      pixels[i] = pixel({static_cast<int>(i % width), first_row + static_cast<int>(i / width)}, counts, cancel);
    }
  }

 private:
  struct Place {
    int column;
    int row;
  };

  /// More bits only for the pixels that need them. Counts the rays of the last attempt.
  Color pixel(const Place& place, RayCounts& counts, const std::atomic<bool>& cancel) const {
    RayCounts counted;
    const auto coarse = traced(coarse_, place, counted, cancel);
    const auto fine = traced(fine_, place, counted, cancel);
    if (agree(coarse, fine)) {
      counts += counted;
      return rounded(fine);
    }
    const auto finest = traced(finest_, place, counted, cancel);
    counts += counted;
    return agree(fine, finest) ? rounded(finest) : Color(std::numeric_limits<double>::quiet_NaN());
  }

  template <class T>
  Vec3<T> traced(const World<T>& world, const Place& place, RayCounts& counted, const std::atomic<bool>& cancel) const {
    counted = {};
    return Tracer<T>(world, counted, cancel).pixel(place.column, place.row, samples_);
  }

  const Scene scene_;
  const Settings settings_;
  const std::vector<Object> objects_;
  const std::vector<SampleOffset> samples_;
  const World<Coarse> coarse_{scene_, objects_, settings_};
  const World<Fine> fine_{scene_, objects_, settings_};
  const World<Finest> finest_{scene_, objects_, settings_};
};

}  // namespace
}  // namespace oracle

std::unique_ptr<Engine> make_oracle(const Scene& scene, const Settings& settings) {
  return std::make_unique<oracle::Oracle>(scene, settings);
}

}  // namespace raylab
