#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {
namespace {

// What a right camera ray is, for the wrong ones to change.
Ray camera_ray(const Camera& camera, int larger, double across, double up) {
  const Vec3 f = unit(camera.facing);
  const Vec3 r = unit(cross(f, camera.up));
  const double s = 2 * std::tan(camera.half_field_of_view * std::acos(-1.0) / 180) / larger;
  return {camera.position, unit(f + across * s * r + up * s * cross(r, f)), {}};
}

}  // namespace

std::vector<Mistake> mistakes_in_rays() {
  return {
      {"1.1", "theta taken for the full angle",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           Camera half = c;
           half.half_field_of_view /= 2;
           return camera_ray(half, std::max(w, h), x - 0.5 + dx, y - 0.5 + dy);
         };
       }},
      {"1.1", "no half pixel",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, std::max(w, h), x + dx, y + dy);
         };
       }},
      {"1.1", "half a pixel to the wrong side",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, std::max(w, h), x + 0.5 + dx, y + 0.5 + dy);
         };
       }},
      {"1.1", "half the screen: tan(theta)/larger for 2 tan(theta)/larger",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, 2 * std::max(w, h), x - 0.5 + dx, y - 0.5 + dy);
         };
       }},
      {"1.1", "upside down",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, std::max(w, h), x - 0.5 + dx, -(y - 0.5 + dy));
         };
       }},
      {"1.1", "mirrored left to right",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, std::max(w, h), -(x - 0.5 + dx), y - 0.5 + dy);
         };
       }},
      {"1.1", "x and y exchanged",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, std::max(w, h), y - 0.5 + dy, x - 0.5 + dx);
         };
       }},
      {"1.1", "the field of view always across the height",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, h, x - 0.5 + dx, y - 0.5 + dy);
         };
       }},
      {"1.1", "the field of view always across the width",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int, double x, double y, double dx, double dy) {
           return camera_ray(c, w, x - 0.5 + dx, y - 0.5 + dy);
         };
       }},
      {"1.1", "direction not unit",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           Ray ray = camera_ray(c, std::max(w, h), x - 0.5 + dx, y - 0.5 + dy);
           ray.direction /= dot(ray.direction, unit(c.facing));
           return ray;
         };
       }},
      {"1.1", "the camera's up taken as it is",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           const Vec3 f = unit(c.facing);
           const double s = 2 * std::tan(c.half_field_of_view * std::acos(-1.0) / 180) / std::max(w, h);
           const Vec3 along = f + (x - 0.5 + dx) * s * unit(cross(f, c.up)) + (y - 0.5 + dy) * s * unit(c.up);
           return Ray{c.position, unit(along), {}};
         };
       }},
      {"1.1", "up always along y",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           Camera upright = c;
           upright.up = {0, 1, 0};
           return camera_ray(upright, std::max(w, h), x - 0.5 + dx, y - 0.5 + dy);
         };
       }},
      {"1.1", "each side has the whole field of view",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           const double larger = std::max(w, h);
           return camera_ray(c, std::max(w, h), (x - 0.5 + dx) * larger / w, (y - 0.5 + dy) * larger / h);
         };
       }},
      {"1.1", "degrees taken for radians",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           const double factor = std::tan(c.half_field_of_view) / std::tan(c.half_field_of_view * std::acos(-1.0) / 180);
           return camera_ray(c, std::max(w, h), factor * (x - 0.5 + dx), factor * (y - 0.5 + dy));
         };
       }},
      {"1.1", "dx and dy left out",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double, double) {
           return camera_ray(c, std::max(w, h), x - 0.5, y - 0.5);
         };
       }},
      {"1.1", "dy down",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return camera_ray(c, std::max(w, h), x - 0.5 + dx, y - 0.5 - dy);
         };
       }},
      {"1.1", "the camera's position left out",
       [](StageTable& t) {
         t.camera_ray = [](const Camera& c, int w, int h, double x, double y, double dx, double dy) {
           return Ray{{}, camera_ray(c, std::max(w, h), x - 0.5 + dx, y - 0.5 + dy).direction, {}};
         };
       }},
  };
}

}  // namespace raylab::test
