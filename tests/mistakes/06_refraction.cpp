#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {
namespace {

std::optional<Ray> index_inverted(const Sphere& sphere, double index, const Hit& hit) {
  return through<right_exit>(sphere, 1 / index, hit);
}
Vec3 refracted_once(const Vec3& inside, const Vec3&, double, const Vec3&) { return inside; }
Vec3 exit_bends_the_wrong_way(const Vec3& inside, const Vec3& n, double index, const Vec3&) {
  return refracted(inside, n, 1 / index).value_or(inside);
}
Vec3 exit_as_it_came(const Vec3&, const Vec3&, double, const Vec3& d) { return d; }
std::optional<Ray> straight_through(const Sphere& sphere, double, const Hit& hit) {
  return through<right_exit>(sphere, 1, hit);
}
std::optional<Ray> exit_at_the_entry(const Sphere& sphere, double index, const Hit& hit) {
  std::optional<Ray> ray = through<right_exit>(sphere, index, hit);
  if (ray) ray->origin = hit.point;
  return ray;
}

double with_sine(double cosine, double n) { return right_schlick(std::sqrt(1 - cosine * cosine), n); }
double by_the_inner_angle(double cosine, double n) {
  return right_schlick(std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (n * n))), n);
}
double fourth_power(double cosine, double n) {
  const double R0 = right_schlick(1, n);
  return R0 + (1 - R0) * std::pow(1 - cosine, 4);
}
double without_R0(double cosine, double) { return std::pow(1 - cosine, 5); }
double R0_not_squared(double cosine, double n) {
  const double R0 = std::abs(1 - n) / (1 + n);
  return R0 + (1 - R0) * std::pow(1 - cosine, 5);
}
double R0_alone(double, double n) { return right_schlick(1, n); }
Weights reversed(double R) { return {1 - R, R}; }
Weights no_reflection(double R) { return {0, 1 - R}; }
Weights refraction_unweighted(double R) { return {R, 1}; }

std::optional<Ray> nan_left_in(const Sphere& sphere, double index, const Hit& hit) {
  std::optional<Ray> ray = through<right_exit>(sphere, index, hit);
  if (!ray) ray = Ray{Vec3(std::asin(2.0)), Vec3(std::asin(2.0)), hit.leaves};
  return ray;
}
std::optional<Ray> total_reflection_on_the_way_in(const Sphere& sphere, double index, const Hit& hit) {
  if (!refracted(hit.direction, hit.normal, index)) return {};
  return through<right_exit>(sphere, index, hit);
}
std::optional<Ray> nothing_enters_thin_glass(const Sphere& sphere, double index, const Hit& hit) {
  if (index < 1) return {};
  return through<right_exit>(sphere, index, hit);
}
std::optional<Ray> leaves_nothing(const Sphere& sphere, double index, const Hit& hit) {
  std::optional<Ray> ray = through<right_exit>(sphere, index, hit);
  if (ray) ray->leaves = {};
  return ray;
}
std::optional<Ray> leaves_inwards(const Sphere& sphere, double index, const Hit& hit) {
  std::optional<Ray> ray = through<right_exit>(sphere, index, hit);
  if (ray) ray->leaves.side = Side::inwards;
  return ray;
}
std::optional<Ray> half_the_chord(const Sphere& sphere, double index, const Hit& hit) {
  std::optional<Ray> ray = through<right_exit>(sphere, index, hit);
  if (ray) ray->origin = (hit.point + ray->origin) / 2.0;
  return ray;
}

std::optional<Ray> chord_of_the_outer_angle(const Sphere& sphere, double index, const Hit& hit) {
  std::optional<Ray> ray = through<right_exit>(sphere, index, hit);
  if (ray) ray->origin = hit.point - 2 * sphere.radius * dot(hit.direction, hit.normal) * unit(ray->origin - hit.point);
  return ray;
}

double what_passes(double cosine, double n) { return 1 - right_schlick(cosine, n); }
double in_degrees(double cosine, double n) { return right_schlick(std::cos(std::acos(cosine) * 180 / std::acos(-1.0)), n); }
double unclamped(double cosine, double n) {
  const double R0 = right_schlick(1, n);
  return R0 + (1 - R0) * std::pow(1 - cosine, 5);
}
double of_common_glass(double cosine, double) { return right_schlick(cosine, 1.5); }

/// A right answer that the mistake then spoils, where the ray meets the glass from inside.
template <void (*spoil)(GlassBounces& both, double index, const Hit& hit)>
void put_inside(StageTable& table) {
  table.glass_bounces = [](const Sphere& sphere, double index, const Hit& hit) {
    GlassBounces both = glass<right_through, right_schlick, right_mix>(sphere, index, hit);
    if (hit.leaves.side == Side::inwards) spoil(both, index, hit);
    return both;
  };
}
void cosine_in_the_glass(GlassBounces& both, double index, const Hit& hit) {
  if (both.refracted.weight == 0) return;
  both.reflected.weight = right_schlick(std::clamp(-dot(hit.direction, hit.normal), 0.0, 1.0), index);
  both.refracted.weight = 1 - both.reflected.weight;
}
void nan_inside(GlassBounces& both, double index, const Hit& hit) {
  if (refracted(hit.direction, hit.normal, index)) return;
  both = {{both.reflected.ray, std::sqrt(-1.0)}, {both.reflected.ray, std::sqrt(-1.0)}};
}
void black_at_total_reflection(GlassBounces& both, double index, const Hit& hit) {
  if (!refracted(hit.direction, hit.normal, index)) both.reflected.weight = 0;
}
void reflected_outwards(GlassBounces& both, double, const Hit&) { both.reflected.ray.leaves.side = Side::outwards; }
void refracted_inwards(GlassBounces& both, double, const Hit&) { both.refracted.ray.leaves.side = Side::inwards; }
void bends_like_from_outside(GlassBounces& both, double index, const Hit& hit) {
  if (both.refracted.weight > 0)
    both.refracted.ray.direction = refracted(hit.direction, hit.normal, 1 / index).value_or(hit.direction);
}

}  // namespace

std::vector<Mistake> mistakes_in_refraction() {
  return {
      {"6.1", "index inverted", put_through<index_inverted>},
      {"6.1", "refracted once", put_through<through<refracted_once>>},
      {"6.1", "the exit bends the wrong way", put_through<through<exit_bends_the_wrong_way>>},
      {"6.1", "leaves in the direction it came in", put_through<through<exit_as_it_came>>},
      {"6.1", "not refracted", put_through<straight_through>},
      {"6.1", "exit from the entry point", put_through<exit_at_the_entry>},
      {"6.1", "asin's NaN left in", put_through<nan_left_in>},
      {"6.1", "total reflection on the way into glass", put_through<total_reflection_on_the_way_in>},
      {"6.1", "nothing enters thin glass", put_through<nothing_enters_thin_glass>},
      {"6.1", "the exit ray leaves nothing", put_through<leaves_nothing>},
      {"6.1", "the exit ray leaves inwards", put_through<leaves_inwards>},
      {"6.1", "half the chord", put_through<half_the_chord>},
      {"6.1", "the chord by the angle in air", put_through<chord_of_the_outer_angle>},
      {"6.2", "1 - R for R", put_schlick<what_passes>},
      {"6.2", "sine for cosine", put_schlick<with_sine>},
      {"6.2", "the inner angle", put_schlick<by_the_inner_angle>},
      {"6.2", "fourth power", put_schlick<fourth_power>},
      {"6.2", "no R0", put_schlick<without_R0>},
      {"6.2", "R0 not squared", put_schlick<R0_not_squared>},
      {"6.2", "R0 at every angle", put_schlick<R0_alone>},
      {"6.2", "the cosine of degrees", put_schlick<in_degrees>},
      {"6.2", "every glass has the index 1.5", put_schlick<of_common_glass>},
      {"6.2", "a cosine beyond 1 not clamped", put_schlick<unclamped>, Shows::in_unit_tests,
       "rounding passes 1 by 1e-16, of which the fifth power is 1e-80"},
      {"6.3", "weights exchanged", put_mix<reversed>},
      {"6.3", "no reflection", put_mix<no_reflection>},
      {"6.3", "refraction not weighted", put_mix<refraction_unweighted>},
      {"6.3", "from inside as from outside",
       [](StageTable& t) {
         t.glass_bounces = [](const Sphere& sphere, double index, const Hit& hit) {
           Hit outside = hit;
           outside.leaves.side = Side::outwards;
           return glass<right_through, right_schlick, right_mix>(sphere, index, outside);
         };
       }},
      {"6.3", "from inside, the cosine in the glass", put_inside<cosine_in_the_glass>},
      {"6.3", "from inside, bent as from outside", put_inside<bends_like_from_outside>},
      {"6.3", "the NaN of total reflection inside left in", put_inside<nan_inside>, Shows::in_floats,
       "8 bits make a NaN black, and so is light that never gets out"},
      {"6.3", "black at total reflection inside", put_inside<black_at_total_reflection>, Shows::in_unit_tests,
       "in a ball it is totally reflected at every point that follows, too, until it ends in black"},
      {"6.3", "the ray reflected inwards leaves outwards", put_inside<reflected_outwards>},
      {"6.3", "the ray refracted out leaves inwards", put_inside<refracted_inwards>},
  };
}

}  // namespace raylab::test
