#include "stages/03_blinn_phong/stage.hpp"

#include <algorithm>
#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

// With the angle between H and N, and the power by exp and log.
float brightness(const glm::vec3& l, const glm::vec3& n, const glm::vec3& v, float alpha) {
  const float diffuse = std::max(0.0f, glm::dot(l, n));
  if (diffuse == 0.0f || alpha == 0.0f || std::isinf(alpha)) return diffuse;
  const glm::vec3 h = l + v;
  const float cosine = std::cos(std::acos(std::clamp(glm::dot(h, n) / glm::length(h), 0.0f, 1.0f)));
  if (cosine <= 0.0f) return diffuse;
  return diffuse + std::tanh(alpha / 400.0f) * std::exp(alpha * std::log(cosine));
}

}  // namespace

double specular_weight(double shininess) {
  const float e = std::exp(static_cast<float>(-shininess) / 200.0f);
  return static_cast<double>((1.0f - e) / (1.0f + e));
}

Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  const float amount = brightness(glm::vec3(l), glm::vec3(n), glm::vec3(v), static_cast<float>(shininess));
  return Color(amount * static_cast<float>(intensity) * glm::vec3(color));
}

Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  const glm::vec3 path = glm::vec3(light.position) - glm::vec3(point);
  const float r = glm::length(path);
  if (r < 1e-6f) return Color(0);
  const float falloff = std::pow(1.0f + r, -2.0f);
  const float amount = brightness(glm::normalize(path), glm::vec3(n), glm::vec3(v), static_cast<float>(material.shininess));
  return Color(amount * falloff * static_cast<float>(light.intensity) * glm::vec3(material.color));
}

Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  return blinn_phong(Vec3(glm::normalize(glm::vec3(-light.direction))), n, v, light.intensity, material.color,
                     material.shininess);
}

Color ambient_light(const AmbientLight& light, const Material& material) {
  return Color(glm::vec3(material.color) * static_cast<float>(light.intensity));
}

Color sum_lights(std::span<const Color> contributions) {
  glm::vec3 sum(0.0f);
  for (std::size_t k = contributions.size(); k-- > 0;) sum += glm::vec3(contributions[k]);
  return Color(sum);
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
