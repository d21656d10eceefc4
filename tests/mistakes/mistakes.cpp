#include "tests/mistakes/mistakes.hpp"

#include "tests/mistakes/building_blocks.hpp"

#include <vector>

namespace raylab::test {
namespace {

// Functions as template arguments, for the mistakes below.

template <double (*diffuse)(double), double (*specular)(const Vec3&, const Vec3&, const Vec3&, double)>
void put_light(StageTable& table) {
  put_blinn_phong<blinn_phong_of<diffuse, specular>>(table);
}

double absolute_diffuse(double l_n) { return std::abs(l_n); }

double unweighted(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  return alpha == 0 || std::isinf(alpha) ? 0 : right_specular(l, n, v, alpha) / weight(alpha);
}
double by_mirror_direction(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot(right_reflect(-l, n), v)), alpha);
}
double half_vector_not_unit(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha)) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot((l + v) / 2.0, n)), alpha);
}
double half_vector_by_difference(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  if (alpha == 0 || std::isinf(alpha) || l == v) return 0;
  return weight(alpha) * std::pow(std::max(0.0, dot(unit(l - v), n)), alpha);
}
double no_specular(const Vec3&, const Vec3&, const Vec3&, double) { return 0; }

template <double (*weight_of)(double alpha)>
double weighted_by(const Vec3& l, const Vec3& n, const Vec3& v, double alpha) {
  return unweighted(l, n, v, alpha) * weight_of(alpha);
}
template <double (*weight_of)(double alpha)>
void put_weight(StageTable& table) {
  put_light<right_diffuse, weighted_by<weight_of>>(table);
  table.specular_weight = weight_of;
}
double over_100(double alpha) { return std::tanh(alpha / 200); }
double exponential_alone(double alpha) { return 1 - std::exp(-alpha / 200); }

Color weight_on_diffuse(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return ((1 - weight(alpha)) * dot(l, n) + right_specular(l, n, v, alpha)) * (intensity * color);
}
Color white_highlight(const Vec3& l, const Vec3& n, const Vec3& v, double intensity, const Color& color, double alpha) {
  if (!(dot(l, n) > 0)) return Color(0);
  return dot(l, n) * intensity * color + Color(right_specular(l, n, v, alpha) * intensity);
}

template <double (*falloff)(double r)>
void put_falloff(StageTable& table) {
  table.point_light = [](const PointLight& light, const Vec3& point, const Vec3& n, const Vec3& v,
                         const Material& material) {
    const Vec3 to_light = light.position - point;
    const double r = length(to_light);
    return blinn_phong_of<right_diffuse, right_specular>(to_light / r, n, v, light.intensity * falloff(r), material.color,
                                                         material.shininess);
  };
}
double inverse_square(double r) { return 1 / (r * r); }
double inverse_one_plus_square(double r) { return 1 / (1 + r * r); }
double inverse(double r) { return 1 / (1 + r); }
double none(double) { return 1; }

template <Vec3 (*reflect)(const Vec3&, const Vec3&)>
void put_reflect(StageTable& table) {
  table.reflect = reflect;
  table.mirror_bounce = [](const Hit& hit, double k_s) {
    return Bounce{{hit.point, reflect(hit.direction, hit.normal), hit.leaves}, k_s};
  };
}
Vec3 equation_on_the_cast_ray(const Vec3& d, const Vec3& n) { return 2 * dot(d, n) * n - d; }
Vec3 half_way(const Vec3& d, const Vec3& n) { return unit(d - 1.9 * dot(d, n) * n); }

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

constexpr Through right_through = through<right_exit>;
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

// What a right camera ray is, for the wrong ones to change.
Ray camera_ray(const Camera& camera, int larger, double across, double up) {
  const Vec3 f = unit(camera.facing);
  const Vec3 r = unit(cross(f, camera.up));
  const double s = 2 * std::tan(camera.half_field_of_view * std::acos(-1.0) / 180) / larger;
  return {camera.position, unit(f + across * s * r + up * s * cross(r, f)), {}};
}

const std::vector<Mistake> mistakes = {
    // 1.1 the ray through a pixel
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

    // 2.1 to 2.4 what a ray meets
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
    {"2.1", "planes seen from one side only",
     [](StageTable& t) {
       t.plane_hit = [](const Ray& ray, const Plane& plane) -> std::optional<double> {
         const double slope = dot(ray.direction, plane.normal);
         if (slope >= 0) return {};
         const double distance = dot(plane.point - ray.origin, plane.normal) / slope;
         return distance >= 0 ? std::optional(distance) : std::nullopt;
       };
     }},
    {"2.2", "the far root",
     [](StageTable& t) {
       t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
         const Vec3 f = ray.origin - sphere.center;
         const double b = dot(f, ray.direction);
         const double d = b * b - dot(f, f) + sphere.radius * sphere.radius;
         if (d < 0 || -b + std::sqrt(d) < 0) return {};
         return -b + std::sqrt(d);
       };
     }},
    {"2.2", "no hit from inside",
     [](StageTable& t) {
       t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
         const Vec3 f = ray.origin - sphere.center;
         const double b = dot(f, ray.direction);
         const double d = b * b - dot(f, f) + sphere.radius * sphere.radius;
         if (d < 0 || -b - std::sqrt(d) < 0) return {};
         return -b - std::sqrt(d);
       };
     }},
    {"2.2", "4ac without the 4",
     [](StageTable& t) {
       t.sphere_hit = [](const Ray& ray, const Sphere& sphere) -> std::optional<double> {
         const Vec3 f = ray.origin - sphere.center;
         const double b = 2 * dot(f, ray.direction);
         const double d = b * b - (dot(f, f) - sphere.radius * sphere.radius);
         if (d < 0) return {};
         const double distance = (-b - std::sqrt(d)) / 2;
         return distance >= 0 ? std::optional(distance) : std::nullopt;
       };
     }},
    {"2.3", "normal inwards",
     [](StageTable& t) {
       t.sphere_normal = [](const Sphere& sphere, const Vec3& point) { return unit(sphere.center - point); };
     }},
    {"2.3", "normal not unit",
     [](StageTable& t) { t.sphere_normal = [](const Sphere& sphere, const Vec3& point) { return point - sphere.center; }; }},
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

    // 3.1 to 3.6 light
    {"3.1", "shininess over 100", put_weight<over_100>},
    {"3.1", "1 - e^-x alone", put_weight<exponential_alone>},
    {"3.2", "no k_s", put_light<right_diffuse, unweighted>},
    {"3.2", "no specular term", put_light<right_diffuse, no_specular>},
    {"3.2", "the absolute value of L.N for the clamp", put_light<absolute_diffuse, right_specular>},
    {"3.2", "Phong's mirror direction for H", put_light<right_diffuse, by_mirror_direction>},
    {"3.2", "H not unit", put_light<right_diffuse, half_vector_not_unit>},
    {"3.2", "H from L - V", put_light<right_diffuse, half_vector_by_difference>},
    {"3.2", "1 - k_s on the diffuse term", put_blinn_phong<weight_on_diffuse>},
    {"3.2", "highlight not tinted by C", put_blinn_phong<white_highlight>},
    {"3.3", "1/r^2", put_falloff<inverse_square>},
    {"3.3", "1/(1 + r^2)", put_falloff<inverse_one_plus_square>},
    {"3.3", "1/(1 + r)", put_falloff<inverse>},
    {"3.3", "no attenuation", put_falloff<none>},
    {"3.3", "L not unit",
     [](StageTable& t) {
       t.point_light = [](const PointLight& light, const Vec3& p, const Vec3& n, const Vec3& v, const Material& m) {
         const Vec3 l = light.position - p;
         const double r = length(l);
         return blinn_phong_of<right_diffuse, right_specular>(l, n, v, light.intensity / ((1 + r) * (1 + r)), m.color,
                                                              m.shininess);
       };
     }},
    {"3.4", "direction reversed",
     [](StageTable& t) {
       t.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& m) {
         return blinn_phong_of<right_diffuse, right_specular>(unit(light.direction), n, v, light.intensity, m.color,
                                                              m.shininess);
       };
     }},
    {"3.4", "direction not unit",
     [](StageTable& t) {
       t.directional_light = [](const DirectionalLight& light, const Vec3& n, const Vec3& v, const Material& m) {
         return blinn_phong_of<right_diffuse, right_specular>(-light.direction, n, v, light.intensity, m.color, m.shininess);
       };
     }},
    {"3.5", "no color",
     [](StageTable& t) { t.ambient_light = [](const AmbientLight& l, const Material&) { return Color(l.intensity); }; }},
    {"3.5", "no intensity",
     [](StageTable& t) { t.ambient_light = [](const AmbientLight&, const Material& m) { return m.color; }; }},
    {"3.6", "the mean, not the sum",
     [](StageTable& t) {
       t.sum_lights = [](std::span<const Color> all) {
         Color sum(0);
         for (const Color& c : all) sum += c / static_cast<double>(all.size());
         return sum;
       };
     }},
    {"3.6", "the last light only",
     [](StageTable& t) { t.sum_lights = [](std::span<const Color> all) { return all.empty() ? Color(0) : all.back(); }; }},

    // 4.1 shadows
    {"4.1", "no shadows", [](StageTable& t) { t.blocked = [](std::span<const Crossing>, double) { return false; }; }},
    {"4.1", "glass blocks",
     [](StageTable& t) {
       t.blocked = [](std::span<const Crossing> all, double distance) {
         return std::any_of(all.begin(), all.end(), [&](const Crossing& c) { return c.t < distance; });
       };
     }},
    {"4.1", "blocked from past the light",
     [](StageTable& t) {
       t.blocked = [](std::span<const Crossing> all, double) {
         return std::any_of(all.begin(), all.end(), [](const Crossing& c) { return !c.transparent; });
       };
     }},
    {"4.1", "only the first geometry asked",
     [](StageTable& t) {
       t.blocked = [](std::span<const Crossing> all, double distance) {
         return !all.empty() && !all[0].transparent && all[0].t < distance;
       };
     }},
    {"4.1", "near blockers forgotten: a shift of 0.5",
     [](StageTable& t) {
       t.blocked = [](std::span<const Crossing> all, double distance) {
         return std::any_of(all.begin(), all.end(),
                            [&](const Crossing& c) { return !c.transparent && c.t > 0.5 && c.t < distance; });
       };
     }},

    // 5.1 to 5.3 reflections
    {"5.1", "equation 4 on the cast ray", put_reflect<equation_on_the_cast_ray>},
    {"5.1", "1.9 for 2", put_reflect<half_way>},
    {"5.2", "reflection not weighted",
     [](StageTable& t) {
       t.mirror_bounce = [](const Hit& hit, double k_s) {
         return Bounce{{hit.point, right_reflect(hit.direction, hit.normal), hit.leaves}, k_s > 0 ? 1.0 : 0.0};
       };
     }},
    {"5.2", "k_s squared",
     [](StageTable& t) {
       t.mirror_bounce = [](const Hit& hit, double k_s) {
         return Bounce{{hit.point, right_reflect(hit.direction, hit.normal), hit.leaves}, k_s * k_s};
       };
     }},
    {"5.2", "the ray forgets what it leaves",
     [](StageTable& t) {
       t.mirror_bounce = [](const Hit& hit, double k_s) {
         return Bounce{{hit.point, right_reflect(hit.direction, hit.normal), {}}, k_s};
       };
     }},
    {"5.3", "one bounce too many",
     [](StageTable& t) { t.go_on = [](int b, int most, double w) { return b <= most + 1 && w != 0; }; }},
    {"5.3", "one bounce too few",
     [](StageTable& t) { t.go_on = [](int b, int most, double w) { return b < most && w != 0; }; }},
    {"5.3", "no limit but 40", [](StageTable& t) { t.go_on = [](int b, int, double w) { return b <= 40 && w != 0; }; }},

    // 6.1 to 6.3 refraction
    {"6.1", "index inverted", put_glass<index_inverted>},
    {"6.1", "refracted once", put_glass<through<refracted_once>>},
    {"6.1", "the exit bends the wrong way", put_glass<through<exit_bends_the_wrong_way>>},
    {"6.1", "leaves in the direction it came in", put_glass<through<exit_as_it_came>>},
    {"6.1", "not refracted", put_glass<straight_through>},
    {"6.1", "exit from the entry point", put_glass<exit_at_the_entry>},
    {"6.2", "sine for cosine", put_glass<right_through, with_sine>},
    {"6.2", "the inner angle", put_glass<right_through, by_the_inner_angle>},
    {"6.2", "fourth power", put_glass<right_through, fourth_power>},
    {"6.2", "no R0", put_glass<right_through, without_R0>},
    {"6.2", "R0 not squared", put_glass<right_through, R0_not_squared>},
    {"6.2", "R0 at every angle", put_glass<right_through, R0_alone>},
    {"6.3", "weights exchanged", put_glass<right_through, right_schlick, reversed>},
    {"6.3", "no reflection", put_glass<right_through, right_schlick, no_reflection>},
    {"6.3", "refraction not weighted", put_glass<right_through, right_schlick, refraction_unweighted>},

    // 7.1, 7.2 anti-aliasing
    {"7.1", "samples at the corners",
     [](StageTable& t) {
       t.sample_positions = [] { return std::vector<SampleOffset>{{.5, .5}, {.5, -.5}, {-.5, -.5}, {-.5, .5}}; };
     }},
    {"7.1", "a square grid",
     [](StageTable& t) {
       t.sample_positions = [] { return std::vector<SampleOffset>{{.25, .25}, {.25, -.25}, {-.25, -.25}, {-.25, .25}}; };
     }},
    {"7.1", "the grid mirrored",
     [](StageTable& t) {
       t.sample_positions = [] {
         return std::vector<SampleOffset>{{-.125, .375}, {-.375, -.125}, {.125, -.375}, {.375, .125}};
       };
     }},
    {"7.1", "one sample four times",
     [](StageTable& t) { t.sample_positions = [] { return std::vector<SampleOffset>(4); }; }},
    {"7.2", "the sum, not the mean",
     [](StageTable& t) {
       t.resolve = [](std::span<const Color> samples) {
         Color sum(0);
         for (const Color& sample : samples) sum += sample;
         return glm::clamp(sum, Color(0), Color(1));
       };
     }},
    {"7.2", "each sample clamped",
     [](StageTable& t) {
       t.resolve = [](std::span<const Color> samples) {
         Color sum(0);
         for (const Color& sample : samples)
           sum += glm::clamp(sample, Color(0), Color(1)) / static_cast<double>(samples.size());
         return sum;
       };
     }},
    {"7.2", "the first sample only",
     [](StageTable& t) {
       t.resolve = [](std::span<const Color> samples) { return glm::clamp(samples[0], Color(0), Color(1)); };
     }},
};

}  // namespace

std::span<const Mistake> known_mistakes() { return mistakes; }

}  // namespace raylab::test
