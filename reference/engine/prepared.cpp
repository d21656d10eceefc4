#include "reference/engine/prepared.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace raylab::fast {
namespace {

using Double3 = Vec3<double>;

Double3 own(const raylab::Vec3& v) { return {v.x, v.y, v.z}; }

template <class T>
Vec3<T> to(const Double3& v) {
  return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}

/// `v` times the power of two that makes its largest component 1 to 2: the same direction, to the bit, and safe to square.
Double3 scaled(const raylab::Vec3& v) {
  const int exponent = -std::ilogb(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
  return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

/// a b - c d to two roundings of the result, however close the products are (Kahan).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

Double3 cross(const Double3& a, const Double3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// `right` comes from the vectors as given, not from their rounded unit vectors: where `up` is almost along `facing`, that
/// rounding would turn the picture.
template <class T>
PreparedCamera<T> prepare_camera(const Camera& camera, const ImageSize& size) {
  const Double3 forward = unit(scaled(camera.facing));
  const Double3 right = unit(cross(scaled(camera.facing), scaled(camera.up)));
  const Double3 up = cross(right, forward);
  const double pixel = 2 * std::tan(camera.half_field_of_view * std::numbers::pi / 180) / std::max(size.width, size.height);
  return {to<T>(own(camera.position)), to<T>(forward), to<T>(pixel * right), to<T>(pixel * up)};
}

template <class T>
Finish<T> prepare_finish(const Material& material, int stage) {
  const double k_s = std::tanh(material.shininess / 400);  // the handout's quotient, free of cancellation at small alpha
  const double n = material.refractive_index;
  const double r = (1 - n) / (1 + n);
  const bool perfect = std::isinf(material.shininess);
  return {.alpha = perfect ? T(0) : static_cast<T>(material.shininess),
          .highlight = perfect ? T(0) : static_cast<T>(k_s),
          .mirror = stage >= 5 ? static_cast<T>(k_s) : T(0),
          .glass = stage >= 6 && material.transparent,
          .n = static_cast<T>(n),
          .n_squared_minus_1 = static_cast<T>((n - 1) * (n + 1)),
          .r0 = static_cast<T>(r * r)};
}

/// The sign of a.b; 0 where rounding `a`, `b` and the sum may have made an exact zero into this.
std::int8_t sign_of_dot(const Double3& a, const Double3& b) {
  const double size = std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
  const double margin = 4 * std::numeric_limits<double>::epsilon() * size;
  const double value = dot(a, b);
  return static_cast<std::int8_t>(value > margin ? 1 : value < -margin ? -1 : 0);
}

Sides sides_of(const PointLight& light, const Scene& scene) {
  Sides sides;
  for (const PlaneObject& plane : scene.planes)
    sides.push_back(sign_of_dot(own(plane.shape.point - light.position), unit(scaled(plane.shape.normal))));
  return sides;
}

Sides sides_of(const DirectionalLight& light, const Scene& scene) {
  Sides sides;
  for (const PlaneObject& plane : scene.planes)
    sides.push_back(sign_of_dot(unit(scaled(light.direction)), unit(scaled(plane.shape.normal))));
  return sides;
}

template <class T>
class Builder {
 public:
  explicit Builder(Prepared<T>& out) : out_(out) {}

  void add_finish(const Material& material) { out_.finishes.push_back(prepare_finish<T>(material, out_.settings.stage)); }

  void add_plane(const PlaneObject& plane) {
    add_finish(plane.material);
    add_surface(plane.material.color);
    out_.planes.point.push_back(to<T>(own(plane.shape.point)));
    out_.planes.normal.push_back(to<T>(unit(scaled(plane.shape.normal))));
  }

  /// The finish is the one added last.
  void add_sphere(const Sphere& sphere, const Color& color, bool transparent) {
    Spheres<T>& spheres = out_.spheres;
    const std::size_t place = spheres.radius.size();
    spheres.center.push_back(to<T>(own(sphere.center)));
    spheres.radius.push_back(static_cast<T>(sphere.radius));
    add_surface(color);
    if (transparent) return;
    if (spheres.opaque.empty() || spheres.opaque.back().end != place)
      spheres.opaque.push_back({place, place + 1});
    else
      ++spheres.opaque.back().end;
  }

  void add_lights(const Scene& scene) {
    double ambient = 0;
    for (const AmbientLight& light : scene.ambient_lights) ambient += light.intensity;
    out_.ambient = static_cast<T>(ambient);
    for (const PointLight& light : scene.point_lights)
      out_.point_lights.push_back({to<T>(own(light.position)), static_cast<T>(light.intensity), sides_of(light, scene)});
    for (const DirectionalLight& light : scene.directional_lights)
      out_.directional_lights.push_back(
          {to<T>(-unit(scaled(light.direction))), static_cast<T>(light.intensity), sides_of(light, scene)});
  }

 private:
  void add_surface(const Color& color) {
    out_.colors.push_back(to<T>(own(color)));
    out_.finish_of.push_back(static_cast<std::uint32_t>(out_.finishes.size() - 1));
  }

  Prepared<T>& out_;
};

}  // namespace

template <class T>
Prepared<T> prepare(const Scene& scene, const Settings& settings) {
  if constexpr (std::is_same_v<T, float>) check_float_range(scene);
  const AntiAliasing by_stage = settings.stage >= 7 ? AntiAliasing::rotated4 : AntiAliasing::none;
  Prepared<T> out;
  out.settings = settings;
  out.samples = sample_offsets(settings.aa.value_or(by_stage));
  out.camera = prepare_camera<T>(scene.camera, settings.size);
  out.background = to<T>(own(scene.background));
  Builder<T> builder(out);
  for (const PlaneObject& plane : scene.planes) builder.add_plane(plane);
  for (const SphereObject& sphere : scene.spheres) {
    builder.add_finish(sphere.material);
    builder.add_sphere(sphere.shape, sphere.material.color, sphere.material.transparent);
  }
  for (const SphereCloud& cloud : scene.clouds) {
    builder.add_finish(cloud.material);
    for (std::size_t i = 0; i < cloud.spheres.size(); ++i)
      builder.add_sphere(cloud.spheres[i], cloud.colors.empty() ? cloud.material.color : cloud.colors[i], false);
  }
  builder.add_lights(scene);
  return out;
}

template Prepared<float> prepare(const Scene&, const Settings&);
template Prepared<double> prepare(const Scene&, const Settings&);

}  // namespace raylab::fast
