#include "bench/report/textbook_tasks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace raylab::bench {
namespace {

/// The tasks in T. Section numbers and decisions [D n] are those of docs/model.md, whose symbols are the names.
template <class T>
struct Textbook {
  using V = glm::vec<3, T>;

  static T in(double x) { return static_cast<T>(x); }
  static V in(const Vec3& v) { return V(v); }

  static V unit(const V& v) { return v / length(v); }

  // ---- 1 Rays

  static Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
    const V f = unit(in(camera.facing));
    const V r = unit(cross(f, in(camera.up)));
    const V u = cross(r, f);
    const T theta = in(camera.half_field_of_view) * std::numbers::pi_v<T> / 180;
    const T s = 2 * std::tan(theta) / static_cast<T>(std::max(width, height));
    const V along = f + (in(x)-T(0.5) + in(dx)) * s * r + (in(y)-T(0.5) + in(dy)) * s * u;
    return {Vec3(in(camera.position)), Vec3(unit(along)), {}};
  }

  // ---- 2 Intersections

  static std::optional<double> plane_hit(const Ray& ray, const Plane& plane) {
    const V o = in(ray.origin), d = in(ray.direction), c = in(plane.point), n = in(plane.normal);
    const T slope = dot(d, n);
    if (slope == 0) return {};
    const T t = dot(c - o, n) / slope;
    if (!(t >= 0)) return {};
    return t;
  }

  static std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
    const V d = in(ray.direction), f = in(ray.origin) - in(sphere.center);
    const T R = in(sphere.radius);
    const T a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - R * R;
    const T discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    const T near = (-b - std::sqrt(discriminant)) / (2 * a);
    if (near >= 0) return near;
    const T far = (-b + std::sqrt(discriminant)) / (2 * a);
    if (far >= 0) return far;
    return {};
  }

  static Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) { return Vec3(unit(in(point)-in(sphere.center))); }

  static std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
    std::optional<std::size_t> nearest;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (candidates[k].t && (!nearest || in(*candidates[k].t) < in(*candidates[*nearest].t))) nearest = k;
    return nearest;
  }

  // ---- 3 Blinn-Phong

  static T k_s(T alpha) {
    if (std::isinf(alpha)) return 1;
    const T e = std::exp(-alpha / 200);
    return (1 - e) / (1 + e);
  }

  static double specular_weight(double shininess) { return k_s(in(shininess)); }

  static T highlight(const V& L, const V& N, const V& V_, T alpha) {
    if (std::isinf(alpha) || L + V_ == V(0)) return 0;  // D10
    return k_s(alpha) * std::pow(std::max(T(0), dot(unit(L + V_), N)), alpha);
  }

  static Color lit(const V& L, const V& N, const V& V_, T intensity, const Color& color, double shininess) {
    if (!(dot(L, N) > 0)) return Color(0);  // D9
    return Color((dot(L, N) + highlight(L, N, V_, in(shininess))) * intensity * in(color));
  }

  static Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color,
                           double shininess) {
    return lit(in(l), in(n), in(v), in(intensity), color, shininess);
  }

  static Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v,
                           const Material& material) {
    const V to_light = in(light.position) - in(point);
    if (to_light == V(0)) return Color(0);
    const T r = length(to_light);
    const T intensity = in(light.intensity) / ((1 + r) * (1 + r));  // D11
    return lit(to_light / r, in(n), in(v), intensity, material.color, material.shininess);
  }

  static Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
    return lit(-unit(in(light.direction)), in(n), in(v), in(light.intensity), material.color, material.shininess);
  }

  static Color ambient_light(const AmbientLight& light, const Material& material) {
    return Color(in(light.intensity) * in(material.color));
  }

  static V sum(std::span<const Color> colors) {
    V total(0);
    for (const Color& color : colors) total += in(color);
    return total;
  }

  static Color sum_lights(std::span<const Color> contributions) { return Color(sum(contributions)); }

  // ---- 4 Shadows

  static bool blocked(std::span<const Crossing> crossings, double distance) {
    return std::any_of(crossings.begin(), crossings.end(),
                       [&](const Crossing& c) { return !c.transparent && in(c.t) < in(distance); });
  }

  // ---- 5 Reflections

  static Vec3 reflect(const Vec3& direction, const Vec3& normal) {
    const V d = in(direction), N = in(normal);
    return Vec3(d - 2 * dot(d, N) * N);  // D13
  }

  static Bounce mirror_bounce(const Hit& hit, double weight) {
    return {{Vec3(in(hit.point)), reflect(hit.direction, hit.normal), hit.leaves}, in(weight)};
  }

  static bool go_on(int bounce, int max_bounces, double weight) { return bounce <= max_bounces && in(weight) != 0; }

  // ---- 6 Refraction

  /// The unit direction at `angle` from the unit `axis`, on the side of it that `d` leans to.
  static V leaning(T angle, const V& axis, const V& d) {
    return std::sin(angle) * unit(d - dot(d, axis) * axis) + std::cos(angle) * axis;
  }

  static std::optional<Ray> through_sphere(const Sphere& sphere, double refractive_index, const Hit& hit) {
    const V d = in(hit.direction), N = in(hit.normal), p = in(hit.point);
    const T n = in(refractive_index);
    const T theta_1 = std::acos(-dot(d, N));
    if (std::sin(theta_1) > n) return {};  // D16
    const T theta_2 = std::asin(std::sin(theta_1) / n);
    const V inner = leaning(theta_2, -N, d);
    const V q = p + 2 * in(sphere.radius) * std::cos(theta_2) * inner;
    const V N2 = unit(q - in(sphere.center));
    const T phi_1 = std::acos(dot(inner, N2));
    const T phi_2 = std::asin(n * std::sin(phi_1));
    return Ray{Vec3(q), Vec3(leaning(phi_2, N2, inner)), hit.leaves};
  }

  static T reflected_part(T cosine, T n) {
    const T R0 = std::pow((1 - n) / (1 + n), T(2));
    return R0 + (1 - R0) * std::pow(1 - cosine, T(5));
  }

  static double schlick(double cos_theta, double refractive_index) {
    return reflected_part(std::clamp(in(cos_theta), T(0), T(1)), in(refractive_index));
  }

  static GlassBounces split(const Hit& hit, T R, const std::optional<Ray>& refracted) {
    const Bounce reflected = mirror_bounce(hit, refracted ? R : 1);
    if (!refracted) return {reflected, {}};
    return {reflected, {*refracted, 1 - R}};
  }

  /// From inside: D17.
  static GlassBounces out_of_sphere(const Hit& hit, T n) {
    const V d = in(hit.direction), N = in(hit.normal);
    const T sine = n * std::sin(std::acos(-dot(d, N)));
    if (sine > 1) return split(hit, 1, {});
    const T theta = std::asin(sine);
    const Ray out{Vec3(in(hit.point)), Vec3(leaning(theta, -N, d)), {hit.leaves.geometry, Side::outwards}};
    return split(hit, reflected_part(std::cos(theta), n), out);
  }

  static GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const Hit& hit) {
    const T n = in(refractive_index);
    if (hit.leaves.side == Side::inwards) return out_of_sphere(hit, n);
    const T cosine = -dot(in(hit.direction), in(hit.normal));
    return split(hit, reflected_part(cosine, n), through_sphere(sphere, refractive_index, hit));
  }

  // ---- 7 SSAA

  static std::vector<SampleOffset> sample_positions() {
    return {{0.125, 0.375}, {0.375, -0.125}, {-0.125, -0.375}, {-0.375, 0.125}};
  }

  static Color resolve(std::span<const Color> samples) {
    const V mean = sum(samples) / static_cast<T>(samples.size());
    const auto clamped = [](T c) { return std::clamp(c, T(0), T(1)); };
    return {clamped(mean.x), clamped(mean.y), clamped(mean.z)};  // D18
  }
};

template <class T>
StageTable table() {
  using Tasks = Textbook<T>;
  StageTable all;
  all.camera_ray = Tasks::camera_ray;
  all.plane_hit = Tasks::plane_hit;
  all.sphere_hit = Tasks::sphere_hit;
  all.sphere_normal = Tasks::sphere_normal;
  all.nearest_hit = Tasks::nearest_hit;
  all.specular_weight = Tasks::specular_weight;
  all.blinn_phong = Tasks::blinn_phong;
  all.point_light = Tasks::point_light;
  all.directional_light = Tasks::directional_light;
  all.ambient_light = Tasks::ambient_light;
  all.sum_lights = Tasks::sum_lights;
  all.blocked = Tasks::blocked;
  all.reflect = Tasks::reflect;
  all.mirror_bounce = Tasks::mirror_bounce;
  all.go_on = Tasks::go_on;
  all.through_sphere = Tasks::through_sphere;
  all.schlick = Tasks::schlick;
  all.glass_bounces = Tasks::glass_bounces;
  all.sample_positions = Tasks::sample_positions;
  all.resolve = Tasks::resolve;
  return all;
}

}  // namespace

StageTable textbook_table(Precision precision) { return precision == Precision::f32 ? table<float>() : table<double>(); }

}  // namespace raylab::bench
