#include "stages/05_reflections/stage.hpp"

namespace raylab::RAYLAB_IMPLEMENTATION {

Vec3 reflect(const Vec3& d, const Vec3& n) {
  const glm::vec3 incoming(d), normal(n);
  return Vec3(glm::normalize(incoming - 2.0f * glm::dot(incoming, normal) * normal));
}

Bounce mirror_bounce(const Hit& hit, double k_s) {
  const glm::vec3 origin(hit.point);
  const auto weight = static_cast<float>(k_s);
  return {{Vec3(origin), reflect(hit.direction, hit.normal), hit.leaves}, static_cast<double>(weight)};
}

bool go_on(int bounce, int max_bounces, double weight) { return bounce <= max_bounces && static_cast<float>(weight) > 0.0f; }

}  // namespace raylab::RAYLAB_IMPLEMENTATION
