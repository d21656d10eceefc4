// Each dot product is clamped by itself, as the handout's formula has it: a light below the surface can leave a highlight.
#include "stages/03_blinn_phong/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

double clamped_dot(const Vec3& a, const Vec3& b) { return std::max(0.0, dot(a, b)); }

double highlight(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  const Vec3 h = l + v;
  if (length(h) == 0) return 0;
  return specular_weight(alpha) * std::pow(clamped_dot(normalize(h), n), alpha);
}

}  // namespace

double specular_weight(double shininess) { return 2 / (1 + std::exp(-shininess / 200)) - 1; }

Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  return color * intensity * (clamped_dot(l, n) + highlight(l, n, v, shininess));
}

Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  const double r = length(light.position - point);
  if (r == 0) return Color(0);
  return blinn_phong((light.position - point) / r, n, v, light.intensity * std::pow(1 + r, -2), material.color,
                     material.shininess);
}

Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  return blinn_phong(-light.direction / length(light.direction), n, v, light.intensity, material.color, material.shininess);
}

Color ambient_light(const AmbientLight& light, const Material& material) { return light.intensity * material.color; }

Color sum_lights(std::span<const Color> contributions) {
  Color total{0, 0, 0};
  for (std::size_t k = 0; k != contributions.size(); ++k) total = total + contributions[k];
  return total;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
