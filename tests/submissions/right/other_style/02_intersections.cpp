#include "stages/02_intersections/stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace raylab::RAYLAB_IMPLEMENTATION {
using namespace std;

namespace {

template <class... Distance>
optional<double> first_ahead(Distance... distances) {
  vector<double> ahead;
  for (const double t : {distances...})
    if (t >= 0) ahead.push_back(t);
  if (ahead.empty()) return nullopt;
  return *min_element(begin(ahead), end(ahead));
}

}  // namespace

optional<double> plane_hit(const Ray& ray, const Plane& plane) {
  const auto n = normalize(plane.normal);
  const auto speed = dot(ray.direction, n), height = dot(ray.origin - plane.point, n);
  if (abs(speed) < numeric_limits<double>::epsilon()) return nullopt;
  return first_ahead(-height / speed);
}

// By Pythagoras: the center's distance from the ray, and half the chord.
optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {
  const auto to_center = sphere.center - ray.origin;
  const auto along = dot(to_center, ray.direction);
  const auto aside = length(to_center - along * ray.direction);
  if (aside > sphere.radius) return nullopt;
  const auto half = sqrt((sphere.radius - aside) * (sphere.radius + aside));
  return first_ahead(along - half, along + half);
}

Vec3 sphere_normal(const Sphere& sphere, const Vec3& point) { return -normalize(sphere.center - point); }

optional<size_t> nearest_hit(span<const Candidate> candidates) {
  vector<pair<double, size_t>> hits;
  for (size_t place = 0; const Candidate& candidate : candidates) {
    if (candidate.t) hits.emplace_back(*candidate.t, place);
    ++place;
  }
  sort(hits.begin(), hits.end());
  if (hits.empty()) return nullopt;
  return hits.front().second;
}

}  // namespace raylab::RAYLAB_IMPLEMENTATION
