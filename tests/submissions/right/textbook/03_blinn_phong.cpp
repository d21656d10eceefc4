#include "stages/03_blinn_phong/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

double specular_weight(double shininess) {
  return (1.0 - std::exp(-shininess / 200.0)) / (1.0 + std::exp(-shininess / 200.0));
}

Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  const double l_dot_n = glm::dot(l, n);
  if (l_dot_n <= 0.0) return Color(0.0, 0.0, 0.0);

  const Color diffuse = intensity * l_dot_n * color;
  if (std::isinf(shininess) || glm::length(l + v) == 0.0) return diffuse;

  const Vec3 h = glm::normalize(l + v);
  const double h_dot_n = std::max(0.0, glm::dot(h, n));
  const Color specular = specular_weight(shininess) * intensity * std::pow(h_dot_n, shininess) * color;
  return diffuse + specular;
}

Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  const double r = glm::distance(light.position, point);
  if (r == 0.0) return Color(0.0);
  const Vec3 l = (light.position - point) / r;
  return blinn_phong(l, n, v, light.intensity / std::pow(1.0 + r, 2.0), material.color, material.shininess);
}

Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  return blinn_phong(glm::normalize(-light.direction), n, v, light.intensity, material.color, material.shininess);
}

Color ambient_light(const AmbientLight& light, const Material& material) { return material.color * light.intensity; }

Color sum_lights(std::span<const Color> contributions) {
  double r = 0.0, g = 0.0, b = 0.0;
  for (const Color& c : contributions) {
    r += c.r;
    g += c.g;
    b += c.b;
  }
  return {r, g, b};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
