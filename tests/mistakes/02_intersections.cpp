#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {
namespace {

/// Of the quadratic for a sphere, b/2 and a quarter of the discriminant: its roots are -b - sqrt(d) and -b + sqrt(d). By
/// the ray's foot, so that a mistake fails the tests for what is wrong and not for its rounding.
struct Quadratic {
  double b, d;
};
Quadratic quadratic(const Ray& ray, const Sphere& sphere) {
  const Vec3 f = ray.origin - sphere.center;
  const double b = dot(f, ray.direction);
  const Vec3 foot = f - b * ray.direction;
  return {b, sphere.radius * sphere.radius - dot(foot, foot)};
}

/// The nearest root that is not behind, as the solution has it, of roots that a mistake has spoiled.
std::optional<double> first_root(double b, double d, double least = 0) {
  if (!(d >= 0)) return {};
  if (-b - std::sqrt(d) >= least) return -b - std::sqrt(d);
  if (-b + std::sqrt(d) >= least) return -b + std::sqrt(d);
  return {};
}

}  // namespace

std::vector<Mistake> mistakes_in_intersections() {
  return {
      {"2.1", "planes behind are seen",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double slope = dot(ray.direction, plane.normal);
           if (slope == 0) return {};
           return std::abs(dot(plane.point - ray.origin, plane.normal) / slope);
         };
       }},
      {"2.1", "missing minus",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double distance = dot(ray.origin - plane.point, plane.normal) / dot(ray.direction, plane.normal);
           return distance >= 0 ? std::optional(distance) : std::nullopt;
         };
       }},
      {"2.1", "the plane at the origin",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double slope = dot(ray.direction, plane.normal);
           if (slope == 0) return {};
           const double distance = -dot(ray.origin, plane.normal) / slope;
           return distance >= 0 ? std::optional(distance) : std::nullopt;
         };
       }},
      {"2.1", "planes seen from one side only",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double slope = dot(ray.direction, plane.normal);
           if (slope >= 0) return {};
           const double distance = dot(plane.point - ray.origin, plane.normal) / slope;
           return distance >= 0 ? std::optional(distance) : std::nullopt;
         };
       }},
      {"2.1", "a negative t returned",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double slope = dot(ray.direction, plane.normal);
           if (slope == 0) return {};
           return dot(plane.point - ray.origin, plane.normal) / slope;
         };
       }},
      {"2.1", "a parallel ray hits at infinity",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double distance = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
           return distance >= 0 ? std::optional(distance) : std::nullopt;
         };
       },
       Shows::in_unit_tests, "no ray of a scene is parallel to a plane to the last bit"},
      {"2.1", "the normal not made unit",
       [](StageTable& t) {
         t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
           const double slope = dot(ray.direction, plane.normal);
           if (slope == 0) return {};
           const double distance = dot(plane.point - ray.origin, plane.normal) / slope;
           return distance >= 0 ? std::optional(distance) : std::nullopt;
         };
       },
       Shows::nowhere, "`t = ((c - o) . n)/(d . n)`: the length of `n` is in both, and cancels"},
      {"2.2", "the far root",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
           const auto [b, d] = quadratic(ray, sphere);
           if (d < 0 || -b + std::sqrt(d) < 0) return {};
           return -b + std::sqrt(d);
         };
       }},
      {"2.2", "no hit from inside",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
           const auto [b, d] = quadratic(ray, sphere);
           if (d < 0 || -b - std::sqrt(d) < 0) return {};
           return -b - std::sqrt(d);
         };
       }},
      {"2.2", "4ac without the 4",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           const double c = b * b - d;
           return first_root(b, b * b - c / 4);
         };
       }},
      {"2.2", "2a left out: the root not halved",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           return first_root(2 * b, 4 * d);
         };
       }},
      {"2.2", "b without its 2",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           const double c = b * b - d;
           return first_root(b / 2, (b * b - 4 * c) / 4);
         };
       }},
      {"2.2", "a negative t returned",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
           const auto [b, d] = quadratic(ray, sphere);
           if (d < 0) return {};
           return -b - std::sqrt(d);
         };
       }},
      {"2.2", "missing minus: b for -b",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           return first_root(-b, d);
         };
       }},
      {"2.2", "the discriminant without 4ac",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const double b = quadratic(ray, sphere).b;
           return first_root(b, b * b);
         };
       }},
      {"2.2", "a miss taken for a hit",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           return first_root(b, std::max(0.0, d));
         };
       }},
      {"2.2", "R for R^2",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           return first_root(b, d - sphere.radius * sphere.radius + sphere.radius);
         };
       }},
      {"2.2", "the sphere at the origin",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, {{}, sphere.radius});
           return first_root(b, d);
         };
       }},
      {"2.2", "a touch taken for a miss",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
           const auto [b, d] = quadratic(ray, sphere);
           if (d == 0) return {};
           return first_root(b, d);
         };
       },
       Shows::in_unit_tests, "rays that touch a sphere without cutting it make no pixel: rounding decides there"},
      {"2.2", "t > 0.001 for t >= 0",
       [](StageTable& t) {
         t.sphere_hit = [](const Ray& ray, const Sphere& sphere) {
           const auto [b, d] = quadratic(ray, sphere);
           return first_root(b, d, 0.001);
         };
       },
       Shows::in_unit_tests, "the driver asks no sphere that the ray leaves, and others are farther, but for single pixels"},
      {"2.3", "normal inwards",
       [](StageTable& t) {
         t.sphere_normal = [](const Sphere& sphere, const Vec3& point) { return unit(sphere.center - point); };
       }},
      {"2.3", "normal not unit",
       [](StageTable& t) {
         t.sphere_normal = [](const Sphere& sphere, const Vec3& point) { return point - sphere.center; };
       }},
      {"2.3", "the center left out",
       [](StageTable& t) { t.sphere_normal = [](const Sphere&, const Vec3& point) { return unit(point); }; }},
      {"2.3", "divided by the radius",
       [](StageTable& t) {
         t.sphere_normal = [](const Sphere& sphere, const Vec3& point) { return (point - sphere.center) / sphere.radius; };
       },
       Shows::nowhere, "the point lies on the sphere: `R` is the length of `p - C`"},
      {"2.4", "the farthest hit",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) {
           std::optional<std::size_t> best;
           for (std::size_t k = 0; k < all.size(); ++k)
             if (all[k].t && (!best || *all[k].t > *all[*best].t)) best = k;
           return best;
         };
       }},
      {"2.4", "the first geometry that is hit",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) {
           std::optional<std::size_t> first;
           for (std::size_t k = all.size(); k-- > 0;)
             if (all[k].t) first = k;
           return first;
         };
       }},
      {"2.4", "the last geometry that is hit",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) {
           std::optional<std::size_t> last;
           for (std::size_t k = 0; k < all.size(); ++k)
             if (all[k].t) last = k;
           return last;
         };
       }},
      {"2.4", "a miss taken for a hit at 0",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) {
           std::optional<std::size_t> best;
           for (std::size_t k = 0; k < all.size(); ++k)
             if (!best || all[k].t.value_or(0) < all[*best].t.value_or(0)) best = k;
           return best;
         };
       },
       Shows::in_unit_tests, "there is no image: the driver refuses the answer, and says so"},
      {"2.4", "the place among the hits only",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) {
           std::optional<std::size_t> best;
           double least = 0;
           std::size_t hits = 0;
           for (const Candidate& c : all) {
             if (!c.t) continue;
             if (!best || *c.t < least) best = hits, least = *c.t;
             ++hits;
           }
           return best;
         };
       },
       Shows::in_unit_tests, "there is no image: the driver refuses an answer that names a miss, and says so"},
      {"2.4", "of equal distances the last",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) {
           std::optional<std::size_t> best;
           for (std::size_t k = 0; k < all.size(); ++k)
             if (all[k].t && (!best || *all[k].t <= *all[*best].t)) best = k;
           return best;
         };
       },
       Shows::in_unit_tests, "no two surfaces of a scene are the same, and where two meet is no pixel"},
      {"2.4", "the geometry's number for its place in the list",
       [](StageTable& t) {
         t.nearest_hit = [](std::span<const Candidate> all) -> std::optional<std::size_t> {
           const Candidate* best = nullptr;
           for (const Candidate& c : all)
             if (c.t && (!best || *c.t < *best->t)) best = &c;
           if (!best) return {};
           return static_cast<std::size_t>(best->geometry);
         };
       },
       Shows::in_unit_tests,
       "numbers and places are the same for the camera's rays; for others the driver refuses the answer"},
  };
}

}  // namespace raylab::test
