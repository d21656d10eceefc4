#include "stages/01_rays/stage.hpp"

#include <cmath>
#include <tuple>

namespace raylab::RAYLAB_IMPLEMENTATION {
using namespace std;

namespace {

struct Basis {
  Vec3 right, up, forward;
};

auto basis_of(const Camera& camera) -> Basis {
  const auto forward = normalize(camera.facing);
  const auto up = normalize(camera.up - dot(camera.up, forward) * forward);
  return {.right = cross(forward, up), .up = up, .forward = forward};
}

}  // namespace

Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  const auto [right, up, forward] = basis_of(camera);
  const auto larger = static_cast<double>(width > height ? width : height);
  const auto tangent = tan(camera.half_field_of_view * acos(-1.0) / 180.0);
  // In the handout's screen coordinates from -1 to 1 along the longer side.
  const auto screen = [&](double pixel, double offset) { return (2 * (pixel + offset) - 1) / larger * tangent; };
  return Ray{
      .origin = camera.position, .direction = normalize(forward + screen(x, dx) * right + screen(y, dy) * up), .leaves = {}};
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
