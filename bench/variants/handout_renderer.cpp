// Compiled once for each set of flags, which RAYLAB_VARIANT_FLAGS names.
#include "bench/variants/handout_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#define RAYLAB_CONCAT(a, b) a##b
#define RAYLAB_MAKER(flags) RAYLAB_CONCAT(make_handout_renderer_, flags)

namespace raylab::bench {
namespace {

template <class Real>
struct Vec {
  Real x = 0, y = 0, z = 0;

  Vec() = default;
  Vec(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
  explicit Vec(const Vec3& v) : x(static_cast<Real>(v.x)), y(static_cast<Real>(v.y)), z(static_cast<Real>(v.z)) {}

  Vec operator-() const { return {-x, -y, -z}; }
  Vec operator+(const Vec& v) const { return {x + v.x, y + v.y, z + v.z}; }
  Vec operator-(const Vec& v) const { return {x - v.x, y - v.y, z - v.z}; }
  Vec operator*(Real s) const { return {x * s, y * s, z * s}; }
  friend Vec operator*(Real s, const Vec& v) { return v * s; }
};

template <class Real>
Real dot(const Vec<Real>& a, const Vec<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Vec<Real> cross(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
Real length(const Vec<Real>& v) {
  return std::sqrt(dot(v, v));
}
/// The zero vector stays zero.
template <class Real>
Vec<Real> unit(const Vec<Real>& v) {
  const Real l = length(v);
  return l > 0 ? v * (1 / l) : v;
}

template <class Real>
class HandoutRenderer : public Engine {
 public:
  HandoutRenderer(const Scene& scene, const Settings& settings, const Variant& variant)
      : variant_(variant), settings_(settings), background_(scene.background), eye_(scene.camera.position) {
    set_camera(scene.camera);
    for (const PlaneObject& p : scene.planes) add_plane(p.shape, p.material);
    for (const SphereObject& s : scene.spheres) add_sphere(s.shape, s.material, s.material.color);
    for (const SphereCloud& cloud : scene.clouds)
      for (std::size_t k = 0; k < cloud.spheres.size(); ++k)
        add_sphere(cloud.spheres[k], cloud.material, cloud.colors.empty() ? cloud.material.color : cloud.colors[k]);
    for (const AmbientLight& l : scene.ambient_lights) lights_.push_back({Light::ambient, {}, Real(l.intensity)});
    for (const PointLight& l : scene.point_lights) lights_.push_back({Light::point, V(l.position), Real(l.intensity)});
    for (const DirectionalLight& l : scene.directional_lights)
      lights_.push_back({Light::directional, -unit(V(l.direction)), Real(l.intensity)});
    if (variant.lights_backwards) std::reverse(lights_.begin(), lights_.end());
    samples_ = sample_offsets(settings.aa.value_or(settings.stage >= 7 ? AntiAliasing::rotated4 : AntiAliasing::none));
  }

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    const auto width = static_cast<std::size_t>(settings_.size.width);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      if (cancel) throw Cancelled{};
      pixels[k] = pixel(static_cast<int>(k % width), first_row + static_cast<int>(k / width), counts);
    }
  }

 private:
  using V = Vec<Real>;
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();

  struct Thing {
    bool is_plane, transparent;
    V center, normal;  // center: of a plane, its point; normal: of a plane
    Real radius;
    V color;
    Real alpha, mirror, n;  // shininess, k_s, refractive index
  };
  struct Light {
    enum { ambient, point, directional } kind;
    V where;  // a point light's position, or the direction to a directional light
    Real intensity;
  };
  struct Ray {
    V o, d;
    int leaves = -1;  // the thing that it starts on, -1 for none
    bool inwards = false;
  };
  struct Hit {
    Real t = infinity;
    int thing = -1;
  };

  // --- The scene

  void set_camera(const Camera& camera) {
    const Real pi = Real(3.14159265358979323846L);
    forward_ = unit(V(camera.facing));
    right_ = unit(cross(forward_, unit(V(camera.up))));
    up_ = cross(right_, forward_);
    const auto longer = static_cast<Real>(std::max(settings_.size.width, settings_.size.height));
    pixel_size_ = 2 * std::tan(Real(camera.half_field_of_view) * pi / 180) / longer;
  }

  static Real mirror_part(Real alpha) { return (1 - std::exp(-alpha / 200)) / (1 + std::exp(-alpha / 200)); }

  void add_plane(const Plane& p, const Material& m) {
    const auto alpha = static_cast<Real>(m.shininess);
    things_.push_back({true, false, V(p.point), unit(V(p.normal)), 0, V(m.color), alpha, mirror_part(alpha), 1});
  }

  void add_sphere(const Sphere& s, const Material& m, const Color& color) {
    const auto alpha = static_cast<Real>(m.shininess);
    things_.push_back({false,
                       m.transparent,
                       V(s.center),
                       {},
                       static_cast<Real>(s.radius),
                       V(color),
                       alpha,
                       mirror_part(alpha),
                       static_cast<Real>(m.refractive_index)});
  }

  // --- Stages 1 and 7: pixels

  Color pixel(int column, int row, RayCounts& counts) const {
    V sum;
    for (const SampleOffset& offset : samples_) {
      const Real x = Real(column + 1) - Real(settings_.size.width) / 2 - Real(0.5) + Real(offset.dx);
      const Real y = Real(settings_.size.height) / 2 - Real(row) - Real(0.5) + Real(offset.dy);
      const V d = unit(forward_ + right_ * (x * pixel_size_) + up_ * (y * pixel_size_));
      ++counts.primary;
      sum = sum + (settings_.stage == 1 ? Real(0.5) * (d + V(1, 1, 1)) : trace({eye_, d}, 0, counts));
    }
    const V mean = sum * (1 / static_cast<Real>(samples_.size()));
    return {std::clamp<double>(mean.x, 0, 1), std::clamp<double>(mean.y, 0, 1), std::clamp<double>(mean.z, 0, 1)};
  }

  V trace(const Ray& ray, int bounce, RayCounts& counts) const {
    if (bounce > settings_.max_bounces) return {};
    const Hit hit = nearest(ray);
    if (hit.thing < 0) return background_;
    const Thing& thing = things_[static_cast<std::size_t>(hit.thing)];
    if (settings_.stage == 2) return thing.color;

    const V p = ray.o + hit.t * ray.d;
    V normal = thing.is_plane ? thing.normal : unit(p - thing.center);
    const bool inside = dot(ray.d, normal) > 0;
    if (inside) normal = -normal;
    if (thing.transparent && settings_.stage >= 6) return glass(thing, hit.thing, ray, p, normal, inside, bounce, counts);

    V color = shade(thing, hit.thing, p, normal, -ray.d, inside, counts);
    if (settings_.stage >= 5 && thing.mirror > 0)
      color = color + thing.mirror * reflection(ray, p, normal, hit.thing, inside, bounce, counts);
    return color;
  }

  // --- Stage 2: what a ray meets

  Hit nearest(const Ray& ray) const {
    Hit hit;
    for (int k = 0; k < static_cast<int>(things_.size()); ++k)
      if (const std::optional<Real> t = meet(ray, k); t && *t < hit.t) hit = {*t, k};
    return hit;
  }

  std::optional<Real> meet(const Ray& ray, int k) const {
    const Thing& thing = things_[static_cast<std::size_t>(k)];
    const V from_center = ray.o - thing.center;
    if (k == ray.leaves) {
      if (thing.is_plane || !ray.inwards) return {};
      return -2 * dot(from_center, ray.d);
    }
    if (!thing.is_plane) return meet_sphere(from_center, ray.d, thing.radius);
    const Real slope = dot(ray.d, thing.normal);
    if (slope == 0) return {};
    const Real t = -dot(from_center, thing.normal) / slope;
    return t >= 0 ? std::optional(t) : std::nullopt;
  }

  std::optional<Real> meet_sphere(const V& from_center, const V& d, Real radius) const {
    Real middle = 0, half = 0;  // of the part of the ray that is inside
    switch (variant_.roots) {
      case Variant::Roots::textbook: {
        const Real a = dot(d, d), b = 2 * dot(from_center, d), c = dot(from_center, from_center) - radius * radius;
        const Real discriminant = b * b - 4 * a * c;
        if (discriminant < 0) return {};
        middle = -b / (2 * a);
        half = std::sqrt(discriminant) / (2 * a);
        break;
      }
      case Variant::Roots::half_b: {
        const Real b = dot(from_center, d), c = dot(from_center, from_center) - radius * radius;
        if (b * b < c) return {};
        middle = -b;
        half = std::sqrt(b * b - c);
        break;
      }
      case Variant::Roots::geometric: {
        middle = -dot(from_center, d);
        const V off_axis = from_center + middle * d;
        const Real distance_squared = dot(off_axis, off_axis);
        if (distance_squared > radius * radius) return {};
        half = std::sqrt(radius * radius - distance_squared);
        break;
      }
    }
    if (middle - half >= 0) return middle - half;
    if (middle + half >= 0) return middle + half;
    return {};
  }

  /// A ray from p on thing `k`: it leaves the thing by its number, or by a shift.
  static Ray start(const V& p, const V& d, int k, bool inwards, double shift) {
    if (shift > 0) return {p + static_cast<Real>(shift) * d, d};
    return {p, d, k, inwards};
  }

  /// A reflected or exit ray on the side of the normal.
  Ray bounced(const V& p, const V& normal, const V& d, int k, bool inwards) const {
    if (variant_.lift > 0) return {p + static_cast<Real>(variant_.lift) * normal, d};
    return start(p, d, k, inwards, variant_.bounce_shift);
  }

  // --- Stages 3 and 4: light

  V shade(const Thing& thing, int k, const V& p, const V& normal, const V& view, bool inside, RayCounts& counts) const {
    V color;
    for (const Light& light : lights_) {
      if (light.kind == Light::ambient) {
        color = color + light.intensity * thing.color;
        continue;
      }
      const V to_light = light.kind == Light::point ? light.where - p : light.where;
      const Real distance = light.kind == Light::point ? length(to_light) : infinity;
      const V l = unit(to_light);
      const Real ln = dot(l, normal);
      if (ln <= 0 && !variant_.clamp_each) continue;
      const Real brightness = std::max(Real(0), ln) + thing.mirror * highlight(thing.alpha, dot(unit(l + view), normal));
      if (brightness == 0 || distance == 0) continue;
      if (settings_.stage >= 4 && blocked(start(p, l, k, inside, variant_.shadow_shift), distance, counts)) continue;
      const Real strength =
          light.kind == Light::point ? light.intensity / ((1 + distance) * (1 + distance)) : light.intensity;
      color = color + brightness * strength * thing.color;
    }
    return color;
  }

  Real highlight(Real alpha, Real hn) const {
    if (hn <= 0 || alpha == infinity) return 0;
    return variant_.power_by_exp_log ? std::exp(alpha * std::log(hn)) : std::pow(hn, alpha);
  }

  bool blocked(const Ray& ray, Real distance, RayCounts& counts) const {
    ++counts.shadow;
    const auto shift = static_cast<Real>(variant_.shadow_shift);
    if (shift > 0 && distance <= shift) return false;
    // A surface that the lamp itself lies on is met at the lamp, but for rounding, and does not block.
    const Real rounding = 1000 * std::numeric_limits<Real>::epsilon() * (distance + length(ray.o));
    const Real limit = distance == infinity ? infinity : distance - shift - rounding;
    for (int k = 0; k < static_cast<int>(things_.size()); ++k) {
      if (things_[static_cast<std::size_t>(k)].transparent) continue;
      if (const std::optional<Real> t = meet(ray, k); t && *t < limit) return true;
    }
    return false;
  }

  // --- Stages 5 and 6: mirrors and glass

  V reflection(const Ray& ray, const V& p, const V& normal, int k, bool inside, int bounce, RayCounts& counts) const {
    ++counts.reflected;
    const V d = unit(ray.d - 2 * dot(ray.d, normal) * normal);
    return trace(bounced(p, normal, d, k, inside), bounce + 1, counts);
  }

  static Real schlick(Real cosine, Real n) {
    const Real r0 = ((1 - n) / (1 + n)) * ((1 - n) / (1 + n));
    return r0 + (1 - r0) * std::pow(1 - cosine, Real(5));
  }

  V glass(const Thing& sphere, int k, const Ray& ray, const V& p, const V& normal, bool inside, int bounce,
          RayCounts& counts) const {
    const Real cosine = std::min(Real(1), -dot(ray.d, normal));
    const Real sine = std::sqrt(1 - cosine * cosine);
    const V reflected = reflection(ray, p, normal, k, inside, bounce, counts);
    if (inside ? sphere.n * sine > 1 : sine > sphere.n) return reflected;

    const Real outer_sine = inside ? sphere.n * sine : sine;
    const Real outer_cosine = inside ? std::sqrt(1 - outer_sine * outer_sine) : cosine;
    const Real r = schlick(outer_cosine, sphere.n);
    std::optional<Ray> out;
    if (inside)
      out = Ray{p, unit(sphere.n * (ray.d + cosine * normal) - outer_cosine * normal)};
    else if (variant_.glass == Variant::Glass::angles)
      out = exit_by_angles(sphere, ray.d, p, normal, cosine);
    else if (variant_.glass == Variant::Glass::vectors)
      out = exit_by_vectors(sphere, ray.d, p, normal, cosine);
    else
      out = exit_by_symmetry(sphere, ray.d, p, normal, cosine);

    ++counts.refracted;
    if (!out) return r * reflected;
    const V outwards = unit(out->o - sphere.center);
    const V refracted = trace(bounced(out->o, outwards, out->d, k, false), bounce + 1, counts);
    return r * reflected + (1 - r) * refracted;
  }

  // Each gives the ray behind a glass sphere that d meets at p, or nothing where rounding leaves none.

  std::optional<Ray> exit_by_angles(const Thing& sphere, const V& d, const V& p, const V& normal, Real cosine) const {
    const Real theta1 = std::acos(cosine);
    const Real theta2 = std::asin(std::sin(theta1) / sphere.n);
    const V inner = unit(std::sin(theta2) * unit(d + cosine * normal) - std::cos(theta2) * normal);
    const V q = p + 2 * sphere.radius * std::cos(theta2) * inner;
    const V normal2 = unit(q - sphere.center);
    const Real phi1 = std::acos(std::min(Real(1), dot(inner, normal2)));
    const Real sine = sphere.n * std::sin(phi1);
    if (sine > 1 && variant_.black_rim) return {};
    const Real phi2 = sine > 1 ? theta1 : std::asin(sine);
    return Ray{q, unit(std::sin(phi2) * unit(inner - dot(inner, normal2) * normal2) + std::cos(phi2) * normal2)};
  }

  std::optional<Ray> exit_by_vectors(const Thing& sphere, const V& d, const V& p, const V& normal, Real cosine) const {
    const Real n = sphere.n;
    const Real k1 = 1 - (1 - cosine * cosine) / (n * n);
    const V inner = unit(d * (1 / n) + (cosine / n - std::sqrt(std::max(Real(0), k1))) * normal);
    const V q = p - 2 * dot(p - sphere.center, inner) * inner;
    const V normal2 = unit(q - sphere.center);
    const Real inner_cosine = dot(inner, normal2);
    const Real k2 = 1 - n * n * (1 - inner_cosine * inner_cosine);
    if (k2 < 0 && variant_.black_rim) return {};
    const Real outer_cosine = k2 < 0 ? cosine : std::sqrt(k2);
    return Ray{q, unit(n * (inner - inner_cosine * normal2) + outer_cosine * normal2)};
  }

  /// The path bends by theta_1 - theta_2 at both ends: it leaves at 2 theta_2 - theta_1 from -normal.
  std::optional<Ray> exit_by_symmetry(const Thing& sphere, const V& d, const V& p, const V& normal, Real cosine) const {
    const V tangent = d + cosine * normal;  // as long as sin(theta_1)
    const Real sine_squared = dot(tangent, tangent);
    const Real cosine2 = std::sqrt(std::max(Real(0), 1 - sine_squared / (sphere.n * sphere.n)));
    const Real cosine_of_twice = 2 * cosine2 * cosine2 - 1;
    const V inner = tangent * (1 / sphere.n) - cosine2 * normal;
    const V out = (2 * cosine2 * cosine / sphere.n - cosine_of_twice) * tangent -
                  (cosine_of_twice * cosine + 2 * cosine2 * sine_squared / sphere.n) * normal;
    return Ray{p + 2 * sphere.radius * cosine2 * inner, unit(out)};
  }

  Variant variant_;
  Settings settings_;
  V background_;
  V eye_, forward_, right_, up_;
  Real pixel_size_ = 0;
  std::vector<Thing> things_;  // planes, spheres, clouds
  std::vector<Light> lights_;
  std::vector<SampleOffset> samples_;
};

}  // namespace

std::unique_ptr<Engine> RAYLAB_MAKER(RAYLAB_VARIANT_FLAGS)(const Scene& scene, const Settings& settings,
                                                           const Variant& variant);

std::unique_ptr<Engine> RAYLAB_MAKER(RAYLAB_VARIANT_FLAGS)(const Scene& scene, const Settings& settings,
                                                           const Variant& variant) {
  if (variant.single_precision) return std::make_unique<HandoutRenderer<float>>(scene, settings, variant);
  return std::make_unique<HandoutRenderer<double>>(scene, settings, variant);
}

}  // namespace raylab::bench
