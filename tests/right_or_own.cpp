#include "tests/right_or_own.hpp"

namespace raylab::test {
namespace {

double specular_weight(double alpha) {
  if (std::isinf(alpha)) return 1;
  return (1 - std::exp(-alpha / 200)) / (1 + std::exp(-alpha / 200));
}

Color blinn_phong(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  const double power = std::isinf(alpha) ? 0 : std::pow(std::max(0.0, dot(unit(l + v), n)), alpha);
  return (dot(l, n) + specular_weight(alpha) * power) * intensity * color;
}

Vec3 reflect(const Vec3& d, const Vec3& n) { return d - 2 * dot(d, n) * n; }

/// With angles and Snell's law twice: right to some 1e-8 near grazing.
std::optional<Ray> through_sphere(const Sphere& sphere, double n, const Hit& hit) {
  const double theta_1 = std::acos(-dot(hit.direction, hit.normal));
  if (std::sin(theta_1) > n) return {};
  const double theta_2 = std::asin(std::sin(theta_1) / n);
  const Vec3 along_surface = unit(hit.direction - dot(hit.direction, hit.normal) * hit.normal);
  const Vec3 inner = std::sin(theta_2) * along_surface - std::cos(theta_2) * hit.normal;
  const Vec3 exit_point = hit.point + 2 * sphere.radius * std::cos(theta_2) * inner;
  const Vec3 exit_normal = (exit_point - sphere.center) / sphere.radius;
  const Vec3 along_exit = unit(inner - dot(inner, exit_normal) * exit_normal);
  return Ray{exit_point, std::sin(theta_1) * along_exit + std::cos(theta_1) * exit_normal, hit.leaves};
}

double schlick(double cosine, double n) {
  const double R0 = std::pow((1 - n) / (1 + n), 2);
  return R0 + (1 - R0) * std::pow(1 - cosine, 5);
}

}  // namespace

const StageTable& printed_tasks() {
  static const StageTable printed = [] {
    StageTable table;
    table.specular_weight = specular_weight;
    table.blinn_phong = blinn_phong;
    table.reflect = reflect;
    table.through_sphere = through_sphere;
    table.schlick = schlick;
    return table;
  }();
  return printed;
}

}  // namespace raylab::test
