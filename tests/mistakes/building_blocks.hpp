#pragma once

// Right tasks on top of wrong ones. A student's stage calls its own functions: whoever gets Schlick wrong gets the glass
// wrong.
#include "core/render/stage_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab::test {

using BlinnPhong = Color (*)(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color,
                             double shininess);

template <BlinnPhong blinn_phong>
void put_blinn_phong(StageTable& table) {
  table.blinn_phong = blinn_phong;
  table.point_light = [](const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v,
                         const Material& material) {
    const Vec3 to_light = light.position - point;
    const double r = length(to_light);
    return blinn_phong(to_light / r, n, v, light.intensity / ((1 + r) * (1 + r)), material.color, material.shininess);
  };
  table.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
    return blinn_phong(-unit(light.direction), n, v, light.intensity, material.color, material.shininess);
  };
}

/// Blinn-Phong with any two of its parts wrong: what L.N gives, and what H.N and the shininess give.
template <double (*diffuse)(double l_n), double (*specular)(const Vec3& l, const Vec3& n, const Vec3& v, double alpha)>
Color blinn_phong_of(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0) && diffuse(-1) == 0) return Color(0);
  return (diffuse(dot(l, n)) + specular(l, n, v, alpha)) * (intensity * color);
}

inline double right_diffuse(double l_n) { return std::max(0.0, l_n); }

inline double weight(double alpha) { return std::tanh(alpha / 400); }

inline double right_specular(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot(unit(l + v), n)), alpha);
}

inline Vec3 right_reflect(const Vec3& d, const Vec3& n) { return d - 2 * dot(d, n) * n; }

inline double right_schlick(double cosine, double n) {
  const double R0 = (1 - n) * (1 - n) / ((1 + n) * (1 + n));
  return R0 + (1 - R0) * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
}

/// Where a ray goes on at a surface, by Snell's law; nothing at total reflection. Right to rounding: a mistake must fail the
/// tests for what is wrong.
inline std::optional<Vec3> refracted(const Vec3& d, const Vec3& n, double ratio) {
  const double cosine = -dot(d, n);
  const double squared = (1 - ratio) * (1 + ratio) + ratio * ratio * cosine * cosine;
  if (squared < 0) return {};
  return ratio * (d + cosine * n) - std::sqrt(squared) * n;
}

/// In and out again; `exit` says where the ray goes on at the second point.
using Exit = Vec3 (*)(const Vec3& inside, const Vec3& n, double index, const Vec3& d);
template <Exit exit>
std::optional<Ray> through(const Sphere& sphere, double index, const Hit& hit) {
  const std::optional<Vec3> inside = refracted(hit.direction, hit.normal, 1 / index);
  if (!inside) return {};
  const Vec3 second = hit.point - 2 * dot(hit.point - sphere.center, *inside) * *inside;
  return Ray{second, unit(exit(*inside, unit(sphere.center - second), index, hit.direction)), hit.leaves};
}

inline Vec3 right_exit(const Vec3& inside, const Vec3& n, double index, const Vec3&) {
  return refracted(inside, n, index).value_or(inside);
}

using Through = std::optional<Ray> (*)(const Sphere& sphere, double index, const Hit& hit);
using Schlick = double (*)(double cosine, double index);

struct Weights {
  double reflected, refracted;
};
using Mix = Weights (*)(double R);
inline Weights right_mix(double R) { return {R, 1 - R}; }

template <Through pass, Schlick schlick, Mix mix>
GlassBounces glass(const Sphere& sphere, double index, const Hit& hit) {
  const Ray mirrored{hit.point, right_reflect(hit.direction, hit.normal), hit.leaves};
  const double cosine = std::clamp(-dot(hit.direction, hit.normal), 0.0, 1.0);
  if (hit.leaves.side == Side::outwards) {
    const std::optional<Ray> exit = pass(sphere, index, hit);
    if (!exit) return {{mirrored, 1}, {}};
    const Weights weights = mix(schlick(cosine, index));
    return {{mirrored, weights.reflected}, {*exit, weights.refracted}};
  }
  const std::optional<Vec3> out = refracted(hit.direction, hit.normal, index);
  if (!out) return {{mirrored, 1}, {}};
  const Weights weights = mix(schlick(std::clamp(-dot(*out, hit.normal), 0.0, 1.0), index));
  return {{mirrored, weights.reflected}, {{hit.point, *out, {hit.leaves.geometry, Side::outwards}}, weights.refracted}};
}

inline constexpr Through right_through = through<right_exit>;

template <Through pass>
void put_through(StageTable& table) {
  table.through_sphere = pass;
  table.glass_bounces = glass<pass, right_schlick, right_mix>;
}

template <Schlick schlick>
void put_schlick(StageTable& table) {
  table.schlick = schlick;
  table.glass_bounces = glass<right_through, schlick, right_mix>;
}

template <Mix mix>
void put_mix(StageTable& table) {
  table.glass_bounces = glass<right_through, right_schlick, mix>;
}

}  // namespace raylab::test
