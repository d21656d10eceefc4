#include "stages/03_blinn_phong/stage.hpp"

#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 3.1: how much a shiny surface mirrors.
double specular_weight(double shininess) {
  // (1 - e^-x) / (1 + e^-x) is tanh(x/2), which keeps its digits where shininess is small and is 1 at infinity.
  return std::tanh(shininess / 400);
}

namespace {

/// max(0, H.N)^alpha for unit vectors, at finite alpha.
double specular_power(const Vec3& h, const Vec3& n, double alpha) {
  if (!(dot(h, n) > 0)) return 0;
  // Near the peak H.N is so close to 1 that rounding it costs most of the power's digits. The gap between the tips of the
  // two vectors is small there and keeps them: H.N = 1 - |H - N|^2 / 2.
  const Vec3 gap = h - n;
  return std::exp(alpha * std::log1p(-dot(gap, gap) / 2));
}

}  // namespace

// Task 3.2: diffuse and specular light from one direction.
Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  const double diffuse = dot(l, n);
  if (!(diffuse > 0)) return Color(0);

  double specular = 0;
  const Vec3 middle = l + v;
  if (shininess > 0 && std::isfinite(shininess) && middle != Vec3(0))
    specular = specular_weight(shininess) * specular_power(unit(middle), n, shininess);
  return (diffuse + specular) * (intensity * color);
}

// Task 3.3: a point light's part.
Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  const Vec3 to_light = light.position - point;
  if (to_light == Vec3(0)) return Color(0);
  const double r = length(to_light);
  const double intensity = light.intensity / ((1 + r) * (1 + r));
  return blinn_phong(unit(to_light), n, v, intensity, material.color, material.shininess);
}

// Task 3.4: a directional light's part.
Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  return blinn_phong(-unit(light.direction), n, v, light.intensity, material.color, material.shininess);
}

// Task 3.5: an ambient light's part.
Color ambient_light(const AmbientLight& light, const Material& material) { return light.intensity * material.color; }

// Task 3.6: all lights together.
Color sum_lights(std::span<const Color> contributions) {
  Color sum(0);
  for (const Color& contribution : contributions) sum += contribution;
  return sum;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
