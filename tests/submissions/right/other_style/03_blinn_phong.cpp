#include "stages/03_blinn_phong/stage.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace raylab::RAYLAB_IMPLEMENTATION {

double specular_weight(double shininess) {
  const double x = std::exp(-shininess / 200);
  return (1 - x) / (1 + x);
}

namespace {

struct Surface {
  Vec3 n, v;
  Color color;
  double alpha;

  [[nodiscard]] double brightness(const Vec3& l) const {
    const double facing = glm::dot(l, n);
    if (facing <= 0) return 0;
    return facing + (shines() ? specular_weight(alpha) * peak(l) : 0);
  }

 private:
  [[nodiscard]] bool shines() const { return alpha > 0 && alpha < std::numeric_limits<double>::infinity(); }
  [[nodiscard]] double peak(const Vec3& l) const {
    return glm::pow(glm::clamp(glm::dot(glm::normalize(l + v), n), 0.0, 1.0), alpha);
  }
};

}  // namespace

Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double shininess) {
  const Surface surface{n, v, color, shininess};
  return surface.brightness(l) * intensity * color;
}

Color point_light(const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v, const Material& material) {
  const Vec3 path = light.position - point;
  if (const double r = glm::length(path); r > 0)
    return blinn_phong(path / r, n, v, light.intensity / (1 + 2 * r + r * r), material.color, material.shininess);
  return {};
}

Color directional_light(const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& material) {
  const Surface surface{n, v, material.color, material.shininess};
  return light.intensity * surface.brightness(glm::normalize(-light.direction)) * material.color;
}

Color ambient_light(const AmbientLight& light, const Material& material) {
  return {light.intensity * material.color.x, light.intensity * material.color.y, light.intensity * material.color.z};
}

Color sum_lights(std::span<const Color> contributions) {
  return std::accumulate(contributions.begin(), contributions.end(), Color(0), std::plus<>());
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
