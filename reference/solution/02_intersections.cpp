#include "stages/02_intersections/stage.hpp"

#include <cmath>

namespace raylab::RAYLAB_IMPLEMENTATION {

// Task 2.1: where a ray meets a plane.
std::optional<double> plane_hit(const Ray& ray, const Plane& plane) {
  const Vec3 n = unit(plane.normal);
  const double approach = dot(ray.direction, n);
  if (approach == 0) return {};  // parallel, or in the plane

  const double t = dot(plane.point - ray.origin, n) / approach;
  if (!(t >= 0)) return {};  // behind the origin; written so that a NaN misses too
  return t;
}

namespace {

/// |p - c|^2 - R^2 for a sphere: negative inside, positive outside.
/// Next to a large sphere this is a small difference of large squares. So each rounding error on the way is worked out as
/// well (by the identities of Knuth's two-sum and of fma) and added at the end.
double height_above(const Vec3& p, const Sphere& sphere) {
  double sum = 0, lost = 0;
  const auto add_square = [&](double x, double sign) {
    const double square = x * x;
    const double before = sum;
    sum += sign * square;
    const double added = sum - before;
    lost += (before - (sum - added)) + (sign * square - added) + sign * std::fma(x, x, -square);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const double a = p[axis], b = sphere.center[axis];
    const double difference = a - b;
    const double b_used = a - difference;
    const double tail = (a - (difference + b_used)) + (b_used - b);
    add_square(difference, +1);
    lost += 2 * difference * tail;
  }
  add_square(sphere.radius, -1);
  return sum + lost;
}

}  // namespace

// Task 2.2: where a ray meets a sphere.
std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
  // The handout's quadratic for a unit d, t^2 + 2 (f.d) t + |f|^2 - R^2 = 0, has the roots t_foot -+ h.
  const Vec3 f = ray.origin - sphere.center;
  const double t_foot = -dot(f, ray.direction);  // of the ray's point nearest to the centre
  const Vec3 foot = f + t_foot * ray.direction;  // that point, seen from the centre

  // Measured from the foot: in b^2 - 4ac a small, far sphere would lose its radius to cancellation.
  const double h_squared = sphere.radius * sphere.radius - dot(foot, foot);
  if (!(h_squared >= 0)) return {};  // passes by; 0 is a touch, and hits
  const double h = std::sqrt(h_squared);

  // The roots' product is |f|^2 - R^2: it says on which side the ray starts, and gives the root that would cancel.
  const double product = height_above(ray.origin, sphere);
  if (product < 0) return t_foot >= 0 ? t_foot + h : product / (t_foot - h);  // inside: the far side
  if (product == 0) return 0.0;
  if (t_foot < 0) return {};  // outside, and the sphere lies behind
  return product / (t_foot + h);
}

// Task 2.3: the direction away from a sphere.
Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) { return unit(point - sphere.center); }

// Task 2.4: the nearest of what a ray meets.
std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
  std::optional<std::size_t> nearest;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (!candidates[k].t) continue;
    if (!nearest || *candidates[k].t < *candidates[*nearest].t) nearest = k;
  }
  return nearest;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
