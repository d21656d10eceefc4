#include "stages/03_blinn_phong/stage.hpp"

#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

namespace {

float k_s(float alpha) {
  const float e = std::exp(-alpha / 200.0f);
  return (1.0f - e) / (1.0f + e);
}

glm::vec3 shade(const glm::vec3& l, const glm::vec3& n, const glm::vec3& v, float intensity, const glm::vec3& color,
                float alpha) {
  const float ln = glm::dot(l, n);
  if (ln <= 0.0f) return glm::vec3(0.0f);
  float specular = 0.0f;
  const glm::vec3 sum = l + v;
  if (!std::isinf(alpha) && glm::length(sum) > 0.0f) {
    const float hn = glm::dot(glm::normalize(sum), n);
    if (hn > 0.0f) specular = k_s(alpha) * std::pow(hn, alpha);
  }
  return (ln + specular) * intensity * color;
}

}  // namespace

double specular_weight(double shininess) { return static_cast<double>(k_s(static_cast<float>(shininess))); }

Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  return Color(shade(glm::vec3(l), glm::vec3(n), glm::vec3(v), static_cast<float>(intensity), glm::vec3(color),
                     static_cast<float>(shininess)));
}

Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  const glm::vec3 to_light = glm::vec3(light.position) - glm::vec3(point);
  const float r = glm::length(to_light);
  if (r == 0.0f) return Color(0);
  const float intensity = static_cast<float>(light.intensity) / ((1.0f + r) * (1.0f + r));
  return Color(shade(to_light / r, glm::vec3(n), glm::vec3(v), intensity, glm::vec3(material.color),
                     static_cast<float>(material.shininess)));
}

Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  const glm::vec3 l = -glm::normalize(glm::vec3(light.direction));
  return Color(shade(l, glm::vec3(n), glm::vec3(v), static_cast<float>(light.intensity), glm::vec3(material.color),
                     static_cast<float>(material.shininess)));
}

Color ambient_light(const AmbientLight& light, const Material& material) {
  return Color(static_cast<float>(light.intensity) * glm::vec3(material.color));
}

Color sum_lights(std::span<const Color> contributions) {
  glm::vec3 sum(0.0f);
  for (const Color& c : contributions) sum += glm::vec3(c);
  return Color(sum);
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
