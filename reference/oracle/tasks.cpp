#include "reference/oracle/tasks.hpp"

#include "core/render/engine.hpp"
#include "reference/oracle/formulas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace raylab {
namespace oracle {
namespace {

using Real = Finest;  // a single call need not be fast
using Vector = Vec3<Real>;

double finite(double x) {
  if (!std::isfinite(x)) throw std::domain_error("the oracle has no answer where a number is not finite");
  return x;
}

/// May be infinite.
double number(double x) {
  if (std::isnan(x)) throw std::domain_error("the oracle has no answer where a number is NaN");
  return x;
}

/// The power that a larger one means hangs on more bits of the cosine than there are.
double checked_shininess(double alpha) {
  if (number(alpha) > 1e100 && std::isfinite(alpha))
    throw std::domain_error("the oracle has no answer for a finite shininess above 1e100");
  return alpha;
}

Vector finite(const raylab::Vec3& v) { return Vector(raylab::Vec3(finite(v.x), finite(v.y), finite(v.z))); }

Vector direction(const raylab::Vec3& v) {
  if (v == raylab::Vec3(0)) throw std::domain_error("the oracle has no answer where a direction has the length 0");
  return unit(finite(v));
}

Ray<Real> unit_ray(const raylab::Ray& ray) { return {finite(ray.origin), direction(ray.direction), ray.leaves}; }

double rounded(const Real& x) { return x.convert_to<double>(); }
raylab::Vec3 rounded(const Vector& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }
raylab::Ray rounded(const Ray<Real>& ray) { return {rounded(ray.origin), rounded(ray.direction), ray.leaves}; }

/// A distance along the unit ray, counted in the direction as it was given.
std::optional<double> rounded(const std::optional<Real>& t, const raylab::Ray& ray) {
  if (!t) return std::nullopt;
  return rounded(*t / length(Vector(ray.direction)));
}

// ---- 1 Rays, 2 Intersections ----------------------------------------------------------------------------------------

raylab::Ray camera_ray(const Camera& camera, int width, int height, double x, double y, double dx, double dy) {
  if (std::abs(camera.half_field_of_view) > 360)
    throw std::domain_error("the oracle has no answer for more than 360 degrees");
  return rounded(Lens<Real>(camera, {width, height}).through(Real(x), Real(y), {dx, dy}));
}

std::optional<double> plane_hit(const raylab::Ray& ray, const Plane& plane) {
  return rounded(meet_plane(unit_ray(ray), finite(plane.point), direction(plane.normal)), ray);
}

std::optional<double> sphere_hit(const raylab::Ray& ray, const Sphere& sphere) {
  return rounded(meet_sphere(unit_ray(ray), finite(sphere.center), Real(finite(sphere.radius))), ray);
}

raylab::Vec3 sphere_normal(const Sphere& sphere, const raylab::Vec3& point) {
  return rounded(unit(Vector(point) - Vector(sphere.center)));
}

std::optional<std::size_t> nearest_hit(std::span<const Candidate> candidates) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].t && (!nearest || number(*candidates[i].t) < number(*candidates[*nearest].t))) nearest = i;
  return nearest;
}

// ---- 3 Blinn-Phong, 4 Shadows ---------------------------------------------------------------------------------------

double specular_weight(double shininess) { return rounded(oracle::specular_weight<Real>(shininess)); }

/// A lamp's part in the color of a surface.
Color lit(const Lamp<Real>& lamp, const raylab::Vec3& n, const raylab::Vec3& v, const Color& color, double shininess) {
  const Vector N = direction(n);
  const Vector V = direction(v);
  if (!above(lamp, N)) return Color(0);
  const Real k_s = oracle::specular_weight<Real>(checked_shininess(shininess));
  return rounded(from_light(lamp, N, V, k_s, shininess) * Vector(color));
}

Color blinn_phong(const raylab::Vec3& l, const raylab::Vec3& n, const raylab::Vec3& v, double intensity, const Color& color,
                  double shininess) {
  return lit({direction(l), std::nullopt, Real(intensity)}, n, v, color, shininess);
}

Color point_light(const PointLight& light, const raylab::Vec3& point, const raylab::Vec3& n, const raylab::Vec3& v,
                  const Material& material) {
  finite(light.position);
  const std::optional<Lamp<Real>> lamp = lamp_at(light, finite(point));
  return lamp ? lit(*lamp, n, v, material.color, material.shininess) : Color(0);
}

Color directional_light(const DirectionalLight& light, const raylab::Vec3& n, const raylab::Vec3& v,
                        const Material& material) {
  return lit({-direction(light.direction), std::nullopt, Real(light.intensity)}, n, v, material.color, material.shininess);
}

Color ambient_light(const AmbientLight& light, const Material& material) {
  return rounded(Real(light.intensity) * Vector(material.color));
}

Vector sum(std::span<const Color> colors) {
  Vector total;
  for (const Color& color : colors) total += Vector(color);
  return total;
}

Color sum_lights(std::span<const Color> contributions) { return rounded(sum(contributions)); }

bool blocked(std::span<const Crossing> crossings, double distance) {
  const auto blocks = [&](const Crossing& c) { return !c.transparent && number(c.t) < number(distance); };
  return std::any_of(crossings.begin(), crossings.end(), blocks);
}

// ---- 5 Reflections, 6 Refraction ------------------------------------------------------------------------------------

raylab::Vec3 reflect(const raylab::Vec3& d, const raylab::Vec3& n) {
  return rounded(oracle::reflect(Vector(d), unit(Vector(n))));
}

Bounce mirror_bounce(const raylab::Hit& hit, double k_s) {
  return {{hit.point, reflect(hit.direction, hit.normal), hit.leaves}, k_s};
}

bool go_on(int bounce, int max_bounces, double weight) { return bounce <= max_bounces && weight != 0; }

Split<Real> split(const raylab::Hit& hit, double n) {
  return split_at_glass(Real(-dot(direction(hit.direction), direction(hit.normal))), hit.leaves.side, Real(finite(n)));
}

/// The ray that glass sends on to its other side, where there is one.
Ray<Real> refracted(const raylab::Hit& hit, const Split<Real>& split, Side side) {
  const Vector along = refract(direction(hit.direction), direction(hit.normal), split.ratio, *split.cos_far);
  return {finite(hit.point), along, {hit.leaves.geometry, side}};
}

std::optional<raylab::Ray> through_sphere(const Sphere& sphere, double refractive_index, const raylab::Hit& hit) {
  raylab::Hit outside = hit;
  outside.leaves.side = Side::outwards;
  const Split<Real> at_p = split(outside, refractive_index);
  if (!at_p.cos_far) return std::nullopt;
  return rounded(exit_ray(refracted(outside, at_p, Side::inwards), finite(sphere.center), Real(refractive_index)));
}

double schlick(double cos_theta, double refractive_index) {
  return rounded(oracle::schlick(Real(cos_theta), Real(refractive_index)));
}

GlassBounces glass_bounces(const Sphere& sphere, double refractive_index, const raylab::Hit& hit) {
  const Split<Real> at_p = split(hit, refractive_index);
  GlassBounces both{mirror_bounce(hit, rounded(at_p.R)), {}};
  if (!at_p.cos_far) return both;
  both.refracted.weight = rounded(Real(1 - at_p.R));
  both.refracted.ray = hit.leaves.side == Side::outwards ? *through_sphere(sphere, refractive_index, hit)
                                                         : rounded(refracted(hit, at_p, Side::outwards));
  return both;
}

// ---- 7 SSAA ---------------------------------------------------------------------------------------------------------

std::vector<SampleOffset> sample_positions() { return sample_offsets(AntiAliasing::rotated4); }

Color resolve(std::span<const Color> samples) { return rounded(clamped(sum(samples) / Real(samples.size()))); }

StageTable table() {
  StageTable all;
  all.camera_ray = camera_ray;
  all.plane_hit = plane_hit;
  all.sphere_hit = sphere_hit;
  all.sphere_normal = sphere_normal;
  all.nearest_hit = nearest_hit;
  all.specular_weight = specular_weight;
  all.blinn_phong = blinn_phong;
  all.point_light = point_light;
  all.directional_light = directional_light;
  all.ambient_light = ambient_light;
  all.sum_lights = sum_lights;
  all.blocked = blocked;
  all.reflect = reflect;
  all.mirror_bounce = mirror_bounce;
  all.go_on = go_on;
  all.through_sphere = through_sphere;
  all.schlick = schlick;
  all.glass_bounces = glass_bounces;
  all.sample_positions = sample_positions;
  all.resolve = resolve;
  return all;
}

}  // namespace
}  // namespace oracle

StageTable oracle_table() { return oracle::table(); }

}  // namespace raylab
