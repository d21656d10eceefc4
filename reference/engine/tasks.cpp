#include "reference/engine/tasks.hpp"

#include "reference/engine/constants.hpp"
#include "reference/engine/prepared.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <limits>
#include <numbers>
#include <tuple>

#define RAYLAB_TARGET foot_log1p::single
#define RAYLAB_INLINE inline
#define RAYLAB_ATTRIBUTE
#include "reference/engine/kernel/parts.hpp"

namespace raylab::fast::foot_log1p::single {
namespace {

/// The tasks in T.
template <class T>
struct Tasks {
  using V3 = single::Vec3<T>;

  static V3 in(const raylab::Vec3& v) { return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)}; }
  static V3 in(const Point<T>& p) { return {p.x, p.y, p.z}; }
  static raylab::Vec3 out(const V3& v) { return {v.x, v.y, v.z}; }

  // ---- 1 Rays

  static raylab::Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
    const auto prepared = prepare_camera<T>(camera, raylab::Vec3(0), {width, height});
    const V3 d = camera_direction(prepared, static_cast<T>(x - 0.5 + dx), static_cast<T>(y - 0.5 + dy));
    return {out(in(prepared.position)), out(d), {}};
  }

  // ---- 2 Intersections

  static std::optional<double> plane_hit(const raylab::Ray& ray, const Plane& plane) {
    const T t = plane_distance(in(ray.origin), in(ray.direction), in(plane.point), in(unit(plane.normal)));
    if (t >= 0 && t < std::numeric_limits<T>::infinity()) return t;
    return {};
  }

  static std::optional<double> sphere_hit(const raylab::Ray& ray, const Sphere& sphere) {
    const V3 o = in(ray.origin), d = in(ray.direction), c = in(sphere.center);
    const T radius = static_cast<T>(sphere.radius);
    const Meeting<T> meeting = meet(true, o, d, c, radius);
    if (meeting.met) return meeting.t;
    return {};
  }

  static raylab::Vec3 sphere_normal(const Sphere& sphere, const raylab::Vec3& point) {
    const V3 away = in(point)-in(sphere.center);
    return out(straightened((1 / square_root(dot(away, away))) * away));
  }

  static std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
    std::optional<std::size_t> nearest;
    T best = std::numeric_limits<T>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (candidates[i].t && static_cast<T>(*candidates[i].t) < best) {
        best = static_cast<T>(*candidates[i].t);
        nearest = i;
      }
    return nearest;
  }

  // ---- 3 Blinn-Phong

  static double specular_weight(double shininess) { return finish_of<T>({{}, shininess}, 7)[mirror]; }

  /// Light of `intensity` from `l`, by a surface of `color`.
  static raylab::Color lit(const V3& l, const V3& n, const V3& v, T intensity, const raylab::Color& color,
                           double shininess) {
    const T cosine = dot(l, n);
    if (!(cosine > 0)) return raylab::Color(0);
    const auto finish = finish_of<T>({{}, shininess}, 7);
    const T shown = cosine + finish[strength] * highlight(finish[strength] > 0, l, n, v, finish[alpha]);
    return out(tinted(shown * intensity, in(color)));
  }

  static raylab::Color blinn_phong(const raylab::Vec3& l, const raylab::Vec3& n, const raylab::Vec3& v, double intensity,
                                   const raylab::Color& color, double shininess) {
    return lit(in(l), in(n), in(v), static_cast<T>(intensity), color, shininess);
  }

  static raylab::Color point_light(const PointLight& light, const raylab::Vec3& point, const raylab::Vec3& n,
                                   const raylab::Vec3& v, const Material& material) {
    const PointSeen<T> seen = see_point(in(point), in(light.position));
    const T strength = static_cast<T>(light.intensity) * (seen.fall_off * seen.fall_off);
    return lit(seen.l, in(n), in(v), strength, material.color, material.shininess);
  }

  static raylab::Color directional_light(const DirectionalLight& light, const raylab::Vec3& n, const raylab::Vec3& v,
                                         const Material& material) {
    return lit(in(-unit(light.direction)), in(n), in(v), static_cast<T>(light.intensity), material.color,
               material.shininess);
  }

  static raylab::Color ambient_light(const AmbientLight& light, const Material& material) {
    return out(tinted(static_cast<T>(light.intensity), in(material.color)));
  }

  static raylab::Color sum_lights(std::span<const raylab::Color> contributions) {
    V3 sum = zero<T>();
    for (const raylab::Color& contribution : contributions) sum = sum + in(contribution);
    return out(sum);
  }

  // ---- 4 Shadows

  static bool blocked(std::span<const Crossing> crossings, double distance) {
    return std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& crossing) {
      return !crossing.transparent && static_cast<T>(crossing.t) < static_cast<T>(distance);
    });
  }

  // ---- 5 Reflections

  /// The engine's own directions are unit vectors, which `mirrored` keeps them; here any length is kept.
  static raylab::Vec3 reflect(const raylab::Vec3& d, const raylab::Vec3& n) {
    const double size = std::hypot(d.x, d.y, d.z);
    return size > 0 ? size * unit_reflected(d / size, n) : d;
  }

  static raylab::Vec3 unit_reflected(const raylab::Vec3& d, const raylab::Vec3& n) { return out(mirrored(in(d), in(n))); }

  static Bounce mirror_bounce(const raylab::Hit& hit, double k_s) {
    return {{out(in(hit.point)), unit_reflected(hit.direction, hit.normal), hit.leaves}, static_cast<T>(k_s)};
  }

  static bool go_on(int bounce, int max_bounces, double weight) {
    return bounce <= max_bounces && static_cast<T>(weight) > 0;
  }

  // ---- 6 Refraction

  /// A ray at glass, as both tasks see it.
  struct AtGlass {
    Glass<T> glass;
    V3 d, normal;
    bool inside;
    Refraction<T> refraction;

    AtGlass(double refractive_index, const raylab::Hit& hit)
        : glass(glass_of(refractive_index)),
          d(in(hit.direction)),
          normal(in(hit.normal)),
          inside(hit.leaves.side == Side::inwards),
          refraction(refract(d, normal, inside, glass)) {}

    raylab::Ray through(const Sphere& sphere, const Leaves& leaves) const {
      const Refracted<T> ray =
          single::through_sphere(refraction, d, normal, in(sphere.center), static_cast<T>(sphere.radius), glass);
      return {out(ray.origin), out(ray.direction), leaves};
    }

    raylab::Ray out_at(const raylab::Vec3& point, GeometryId geometry) const {
      const Refracted<T> ray = out_of_sphere(refraction, d, normal, in(point), glass);
      return {out(ray.origin), out(ray.direction), {geometry, Side::outwards}};
    }
  };

  static Glass<T> glass_of(double n) {
    const auto finish = finish_of<T>({{}, 0, true, n}, 7);
    return {finish[ior], finish[ior_squared_minus_1], finish[r0]};
  }

  static std::optional<raylab::Ray> through_sphere(const Sphere& sphere, double refractive_index, const raylab::Hit& hit) {
    const AtGlass at(refractive_index, hit);
    if (at.refraction.total) return {};
    return at.through(sphere, hit.leaves);
  }

  static double schlick(double cos_theta, double refractive_index) {
    const T cosine = clamped(static_cast<T>(cos_theta));
    return single::schlick<T>({cosine, 0, false}, false, glass_of(refractive_index)).reflected;
  }

  static GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const raylab::Hit& hit) {
    const AtGlass at(refractive_index, hit);
    const Parts<T> parts = single::schlick(at.refraction, at.inside, at.glass);
    const Bounce reflected = mirror_bounce(hit, parts.reflected);
    if (at.refraction.total) return {reflected, {}};
    return {reflected,
            {at.inside ? at.out_at(hit.point, hit.leaves.geometry) : at.through(sphere, hit.leaves), parts.refracted}};
  }

  // ---- 7 SSAA

  static std::vector<SampleOffset> sample_positions() { return sample_offsets(AntiAliasing::rotated4); }

  static raylab::Color resolve(std::span<const raylab::Color> samples) {
    const V3 sum = pairwise_sum<T>(samples, [](const raylab::Color& sample) { return in(sample); });
    const V3 mean = (T(1) / static_cast<T>(samples.size())) * sum;
    return {clamped(mean.x), clamped(mean.y), clamped(mean.z)};
  }
};

template <class T>
StageTable table() {
  StageTable all;
  all.camera_ray = Tasks<T>::camera_ray;
  all.plane_hit = Tasks<T>::plane_hit;
  all.sphere_hit = Tasks<T>::sphere_hit;
  all.sphere_normal = Tasks<T>::sphere_normal;
  all.nearest_hit = Tasks<T>::nearest_hit;
  all.specular_weight = Tasks<T>::specular_weight;
  all.blinn_phong = Tasks<T>::blinn_phong;
  all.point_light = Tasks<T>::point_light;
  all.directional_light = Tasks<T>::directional_light;
  all.ambient_light = Tasks<T>::ambient_light;
  all.sum_lights = Tasks<T>::sum_lights;
  all.blocked = Tasks<T>::blocked;
  all.reflect = Tasks<T>::reflect;
  all.mirror_bounce = Tasks<T>::mirror_bounce;
  all.go_on = Tasks<T>::go_on;
  all.through_sphere = Tasks<T>::through_sphere;
  all.schlick = Tasks<T>::schlick;
  all.glass_bounces = Tasks<T>::glass_bounces;
  all.sample_positions = Tasks<T>::sample_positions;
  all.resolve = Tasks<T>::resolve;
  return all;
}

}  // namespace
}  // namespace raylab::fast::foot_log1p::single

namespace raylab {

StageTable fast_table(Precision precision) {
  return precision == Precision::f32 ? fast::foot_log1p::single::table<float>() : fast::foot_log1p::single::table<double>();
}

}  // namespace raylab
