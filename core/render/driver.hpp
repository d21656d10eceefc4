#pragma once

#include "core/math/hit.hpp"
#include "core/math/seen.hpp"
#include "core/render/engine.hpp"
#include "core/scene/scene.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

/// The part of the renderer that is given: it follows rays through the scene and asks the tasks what to do, and never
/// computes what a task computes. docs/driver.md explains it line by line; its parts stand in the order of the stages.
///
/// `Table` has one callable member for each task: StageTable's pointers, or static functions that the compiler can see
/// through. A Driver serves one thread, for as long as its arguments live.
template <class Table>
class Driver {
 public:
  Driver(const Scene& scene, const Settings& settings, const Table& table, const std::vector<RayFilter>& filters,
         RayCounts& counts, const std::atomic<bool>& cancel)
      : scene_(scene),
        settings_(settings),
        table_(table),
        filters_(filters),
        counts_(counts),
        cancel_(cancel),
        offsets_(settings.aa ? sample_offsets(*settings.aa)
                 : has(ssaa) ? table.sample_positions()
                             : sample_offsets(AntiAliasing::none)) {}

  /// The final color of the pixel in column i from the left and row j from the top.
  Color pixel(int i, int j) {
    samples_.clear();
    for (const SampleOffset& offset : offsets_) {
      if (settings_.aa == AntiAliasing::adaptive && samples_.size() == deciding_samples && samples_agree(samples_)) break;
      samples_.push_back(sample(i, j, offset));
    }
    return has(ssaa) ? table_.resolve(samples_) : mean_of_samples();
  }

 private:
  enum Stage { rays = 1, intersections, blinn_phong, shadows, reflections, refraction, ssaa };

  bool has(Stage stage) const { return settings_.stage >= stage; }

  // Stage 1: one ray for each sample.

  Color sample(int i, int j, const SampleOffset& offset) {
    const auto [width, height] = settings_.size;
    const double x = i + 1 - width / 2.0;
    const double y = height / 2.0 - j;
    const Ray ray = table_.camera_ray(scene_.camera, width, height, x, y, offset.dx, offset.dy);
    ++counts_.primary;
    if (!has(intersections)) return filtered(ray, {}, 0, (ray.direction + 1.0) / 2.0);
    return color(ray, 0);
  }

  /// What is seen along a ray. The recursion: surface_color() sends further rays, each one bounce up.
  Color color(const Ray& ray, int bounce) {
    const std::optional<Hit> hit = first_hit(ray);
    return filtered(ray, hit, bounce, hit ? surface_color(*hit, bounce) : scene_.background);
  }

  Color surface_color(const Hit& hit, int bounce) {
    const Material material = material_of(hit.leaves.geometry);
    if (!has(blinn_phong)) return material.color;
    if (has(refraction) && material.transparent) return glass(hit, material, bounce);
    const Color lit = light(hit, material);
    return has(reflections) ? lit + mirror(hit, material, bounce) : lit;
  }

  Color filtered(const Ray& ray, const std::optional<Hit>& hit, int bounce, Color seen) const {
    for (const RayFilter filter : filters_)
      seen = filter({seen, ray, hit ? std::optional(hit->t) : std::nullopt, scene_.background, bounce});
    return seen;
  }

  // Stage 2: what a ray meets first.

  std::optional<Hit> first_hit(const Ray& ray) {
    candidates_.clear();
    ask_all(ray, [&](GeometryId id, std::optional<double> t, bool) { candidates_.push_back({id, t}); });
    const std::optional<std::size_t> nearest = table_.nearest_hit(candidates_);
    if (!nearest) return {};
    if (*nearest >= candidates_.size() || !candidates_[*nearest].t)
      throw std::runtime_error("task 2.4 nearest_hit chose place " + std::to_string(*nearest) + " (from 0) of a list of " +
                               std::to_string(candidates_.size()) +
                               ", where no hit stands; 'raylab test 2.4' shows such a call");
    return hit_at(ray, candidates_[*nearest].geometry, *candidates_[*nearest].t);
  }

  /// Calls visit(id, t, transparent) for each geometry but the one that the ray leaves: that can be met again only from
  /// inside, at the far side, which needs no search.
  template <class Visit>
  void ask_all(const Ray& ray, Visit visit) const {
    if (cancel_.load(std::memory_order_relaxed)) throw Cancelled{};
    GeometryId id = 0;
    for (const PlaneObject& plane : scene_.planes) {
      if (ray.leaves.geometry != id) visit(id, table_.plane_hit(ray, plane.shape), plane.material.transparent);
      ++id;
    }
    const auto ask_sphere = [&](const Sphere& sphere, bool transparent) {
      if (ray.leaves.geometry != id)
        visit(id, table_.sphere_hit(ray, sphere), transparent);
      else if (ray.leaves.side == Side::inwards)
        visit(id, far_side(ray, sphere), transparent);
      ++id;
    };
    for (const SphereObject& sphere : scene_.spheres) ask_sphere(sphere.shape, sphere.material.transparent);
    for (const SphereCloud& cloud : scene_.clouds)
      for (const Sphere& sphere : cloud.spheres) ask_sphere(sphere, cloud.material.transparent);
  }

  /// Of a ray from the sphere itself; the root is for one that starts a little inside.
  static std::optional<double> far_side(const Ray& ray, const Sphere& sphere) {
    const Vec3 from_center = ray.origin - sphere.center;
    const double to_middle = -dot(from_center, ray.direction);
    const double gap = (sphere.radius - length(from_center)) * (sphere.radius + length(from_center));
    if (gap < 1e-9 * sphere.radius * sphere.radius) return std::max(0.0, 2 * to_middle);
    return to_middle + std::sqrt(to_middle * to_middle + gap);
  }

  Hit hit_at(const Ray& ray, GeometryId id, double t) const {
    const Vec3 point = ray.origin + t * ray.direction;
    if (id < plane_count()) {
      const Vec3 normal = unit(scene_.planes[static_cast<std::size_t>(id)].shape.normal);
      return {t, point, ray.direction, dot(ray.direction, normal) > 0 ? -normal : normal, {id, Side::outwards}};
    }
    const Vec3 outward = table_.sphere_normal(sphere_of(id), point);
    const bool inside = dot(ray.direction, outward) > 0;
    return {t, point, ray.direction, inside ? -outward : outward, {id, inside ? Side::inwards : Side::outwards}};
  }

  // Stages 3 and 4: the light that reaches a surface point.

  Color light(const Hit& hit, const Material& material) {
    const Vec3 v = -hit.direction;
    contributions_.clear();
    for (const AmbientLight& l : scene_.ambient_lights) contributions_.push_back(table_.ambient_light(l, material));
    for (const PointLight& l : scene_.point_lights)
      if (!in_shadow(hit, l.position - hit.point, length(l.position - hit.point)))
        contributions_.push_back(table_.point_light(l, hit.point, hit.normal, v, material));
    for (const DirectionalLight& l : scene_.directional_lights)
      if (!in_shadow(hit, -l.direction, std::numeric_limits<double>::infinity()))
        contributions_.push_back(table_.directional_light(l, hit.normal, v, material));
    return table_.sum_lights(contributions_);
  }

  /// to_light: any length. A light below the surface is dark without a shadow.
  bool in_shadow(const Hit& hit, const Vec3& to_light, double distance) {
    if (!has(shadows)) return false;
    const Vec3 l = unit(to_light);
    if (!(dot(l, hit.normal) > 0)) return false;
    const Ray ray{hit.point, l, hit.leaves};
    ++counts_.shadow;
    crossings_.clear();
    ask_all(ray, [&](GeometryId, std::optional<double> t, bool transparent) {
      if (t && !at_light(*t, distance, hit.point)) crossings_.push_back({*t, transparent});
    });
    return table_.blocked(crossings_, distance);
  }

  /// Is a surface at distance t the one that the light itself lies on, a lamp in a ceiling, say? It does not block, and
  /// rounding must not decide that anew at every pixel.
  static bool at_light(double t, double distance, const Vec3& point) {
    return std::isfinite(distance) && std::abs(t - distance) <= 1e-12 * (length(point) + distance);
  }

  // Stages 5 and 6: the rays that a surface sends on.

  Color mirror(const Hit& hit, const Material& material, int bounce) {
    const double k_s = table_.specular_weight(material.shininess);
    return follow(table_.mirror_bounce(hit, k_s), bounce + 1, counts_.reflected);
  }

  Color glass(const Hit& hit, const Material& material, int bounce) {
    const GlassBounces both = table_.glass_bounces(sphere_of(hit.leaves.geometry), material.refractive_index, hit);
    const Color reflected = follow(both.reflected, bounce + 1, counts_.reflected);
    return reflected + follow(both.refracted, bounce + 1, counts_.refracted);
  }

  Color follow(const Bounce& next, int bounce, std::uint64_t& count) {
    if (!table_.go_on(bounce, settings_.max_bounces, next.weight)) return Color(0);
    ++count;
    return next.weight * color(next.ray, bounce);
  }

  // Stage 7 is pixel(), above. Before it the driver itself takes the mean of what --aa asks for.

  Color mean_of_samples() const {
    Color sum(0);
    for (const Color& sample : samples_) sum += sample;
    const Color mean = sum / static_cast<double>(samples_.size());
    return {std::clamp(mean.r, 0.0, 1.0), std::clamp(mean.g, 0.0, 1.0), std::clamp(mean.b, 0.0, 1.0)};
  }

  // Looking geometries up by their number.

  GeometryId plane_count() const { return static_cast<GeometryId>(scene_.planes.size()); }

  const Sphere& sphere_of(GeometryId id) const {
    auto index = static_cast<std::size_t>(id - plane_count());
    if (index < scene_.spheres.size()) return scene_.spheres[index].shape;
    index -= scene_.spheres.size();
    const SphereCloud& cloud = cloud_of(index);
    return cloud.spheres[index];
  }

  Material material_of(GeometryId id) const {
    if (id < plane_count()) return scene_.planes[static_cast<std::size_t>(id)].material;
    auto index = static_cast<std::size_t>(id - plane_count());
    if (index < scene_.spheres.size()) return scene_.spheres[index].material;
    index -= scene_.spheres.size();
    const SphereCloud& cloud = cloud_of(index);
    Material material = cloud.material;
    if (!cloud.colors.empty()) material.color = cloud.colors[index];
    return material;
  }

  /// The cloud that holds the index-th sphere of all clouds; `index` becomes its place there.
  const SphereCloud& cloud_of(std::size_t& index) const {
    auto cloud = scene_.clouds.begin();
    for (; index >= cloud->spheres.size(); ++cloud) index -= cloud->spheres.size();
    return *cloud;
  }

  const Scene& scene_;
  const Settings& settings_;
  const Table& table_;
  const std::vector<RayFilter>& filters_;
  RayCounts& counts_;
  const std::atomic<bool>& cancel_;
  const std::vector<SampleOffset> offsets_;
  // Lists that each ray fills anew; kept to spare their allocation.
  std::vector<Color> samples_;
  std::vector<Candidate> candidates_;
  std::vector<Crossing> crossings_;
  std::vector<Color> contributions_;
};

/// The driver with a table as an engine. `scene` must live as long as it. Whatever a task throws comes out of trace_rows().
template <class Table>
class DriverEngine final : public Engine {
 public:
  DriverEngine(const Scene& scene, const Settings& settings, const Table& table, std::vector<RayFilter> filters)
      : scene_(scene), settings_(settings), table_(table), filters_(std::move(filters)) {}

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    Driver<Table> driver(scene_, settings_, table_, filters_, counts, cancel);
    const auto width = static_cast<std::size_t>(settings_.size.width);
    for (std::size_t k = 0; k < pixels.size(); ++k)
      pixels[k] = driver.pixel(static_cast<int>(k % width), first_row + static_cast<int>(k / width));
  }

 private:
  const Scene& scene_;
  const Settings settings_;
  const Table table_;
  const std::vector<RayFilter> filters_;
};

}  // namespace raylab
