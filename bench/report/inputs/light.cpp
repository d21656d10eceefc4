#include "bench/report/inputs/families.hpp"

#include <cmath>
#include <limits>
#include <tuple>

namespace raylab::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- 3 Blinn-Phong, 4 Shadows

/// Unit vectors from a point: to the light, along the normal, to the viewer.
struct Lit {
  Vec3 l, n, v;
};

/// A point of a surface, and its shininess.
struct Shiny {
  Lit lit;
  double shininess;
};

/// The vector halfway between l and v is `off` radians from n, but for the cube of that.
Lit near_peak(Random& random, double off) {
  const Vec3 n = random.direction(), h = random.tilted(n, off);
  const Vec3 l = random.tilted(h, random.between(0, 0.8));
  return {l, n, unit(2 * dot(l, h) * h - l)};
}

Shiny peak(Random& random) { return {near_peak(random, random.between(0, 3) / std::sqrt(1000)), 1000}; }

Material shiny(Random& random, double shininess) { return {random.color(), shininess, false, 1.5}; }

void add_reflected_light(TaskFamilies& to, const Families& add) {
  add.ordinary(to.specular_weight, "A shininess from 1 to 2000.", [](Random& r) { return std::tuple{r.between(1, 2000)}; });
  add.hard(to.specular_weight, "nearly matte", "A shininess from 1 down to 1e-15: 1 - e^(-alpha/200) cancels.",
           [](Random& r) { return std::tuple{r.spread(-50, 0)}; });
  add.hard(to.specular_weight, "nearly a perfect mirror",
           "A shininess from 2000 to 1e15, or infinity: the weight is 1 but for rounding.",
           [](Random& r) { return std::tuple{r.chance(0.1) ? infinity : r.spread(11, 49)}; });

  const auto lit_by = [](Random& r, const Shiny& surface) {
    const auto& [lit, shininess] = surface;
    return std::tuple{lit.l, lit.n, lit.v, r.between(0.5, 5), r.color(), shininess};
  };
  add.ordinary(to.blinn_phong, "A light from anywhere, half of them below the surface; a shininess from 1 to 300.",
               [&](Random& r) {
                 const Vec3 n = r.direction();
                 return lit_by(r, {{r.direction(), n, r.above(n)}, r.between(1, 300)});
               });
  add.hard(to.blinn_phong, "near the peak",
           "Shininess 1000, where the highlight shows: the cosine is next to 1, and rounding it costs most of the power's "
           "digits.",
           [&](Random& r) { return lit_by(r, peak(r)); });
  add.hard(to.blinn_phong, "near a sharp peak",
           "The same with a shininess from 8192 to 1e12: a point of light, whose cosine differs from 1 by less and less.",
           [&](Random& r) {
             const double shininess = r.spread(13, 40);
             return lit_by(r, {near_peak(r, r.between(0, 3) / std::sqrt(shininess)), shininess});
           });
  add.hard(to.blinn_phong, "grazing light",
           "The light stands 1/32 to a millionth of a radian above the surface: the cosine cancels.", [&](Random& r) {
             const Vec3 n = r.direction(), l = r.raised(n, r.spread(-20, -5));
             return lit_by(r, {{l, n, r.above(n)}, r.between(1, 300)});
           });
  add.hard(to.blinn_phong, "light opposite the viewer",
           "Light and viewer both graze the surface from opposite sides: the sum of their vectors nearly vanishes.",
           [&](Random& r) {
             const Vec3 n = r.direction(), along = r.across(n);
             const auto raised = [&](const Vec3& way) { return unit(way + r.spread(-16, -3) * n); };
             return lit_by(r, {{raised(along), n, raised(-along)}, r.between(1, 50)});
           });
}

void add_lights(TaskFamilies& to, const Families& add) {
  const auto point_light = [](Random& r, const Shiny& surface, double distance) {
    const auto& [lit, shininess] = surface;
    const Vec3 p = r.point();
    return std::tuple{PointLight{p + distance * lit.l, r.between(1, 100)}, p, lit.n, lit.v, shiny(r, shininess)};
  };
  const auto any = [](Random& r) {
    const Vec3 n = r.direction();
    return Shiny{{r.above(n), n, r.above(n)}, r.between(1, 300)};
  };
  add.ordinary(to.point_light, "A light 1 to 20 away from a point of a surface with a shininess from 1 to 300.",
               [&](Random& r) {
                 const Shiny surface = any(r);
                 return point_light(r, surface, r.between(1, 20));
               });
  add.hard(to.point_light, "very near", "The light is 1/8 to 1e-5 from the point: their positions nearly cancel.",
           [&](Random& r) {
             const Shiny surface = any(r);
             return point_light(r, surface, r.spread(-16, -3));
           });
  add.hard(to.point_light, "very far", "The light is 1e3 to 1e8 away.", [&](Random& r) {
    const Shiny surface = any(r);
    return point_light(r, surface, r.spread(10, 26));
  });
  add.hard(to.point_light, "near the peak", "Shininess 1000, where the highlight shows: the cosine is next to 1.",
           [&](Random& r) {
             const Shiny surface = peak(r);
             return point_light(r, surface, r.between(1, 20));
           });

  const auto sun = [](Random& r, const Shiny& surface, double length) {
    const auto& [lit, shininess] = surface;
    return std::tuple{DirectionalLight{-length * lit.l, r.between(0.1, 1)}, lit.n, lit.v, shiny(r, shininess)};
  };
  add.ordinary(to.directional_light, "Light from above a surface with a shininess from 1 to 300.", [&](Random& r) {
    const Shiny surface = any(r);
    return sun(r, surface, r.between(0.5, 2));
  });
  add.hard(to.directional_light, "directions of any length",
           "The light's direction is 1e-30 to 1e30 long: in float its square vanishes or overflows.", [&](Random& r) {
             const Shiny surface = any(r);
             return sun(r, surface, r.spread(-100, 100));
           });
  add.hard(to.directional_light, "near the peak", "Shininess 1000, where the highlight shows: the cosine is next to 1.",
           [&](Random& r) {
             const Shiny surface = peak(r);
             return sun(r, surface, r.between(0.5, 2));
           });

  add.ordinary(to.ambient_light, "Any color, any intensity up to 1.", [](Random& r) {
    return std::tuple{AmbientLight{r.between(0, 1)}, shiny(r, 0)};
  });
}

void add_sums_and_shadows(TaskFamilies& to, const Families& add) {
  add.ordinary(to.sum_lights, "Four lights.", [](Random& r) { return std::tuple{list_of(4, [&] { return r.color(); })}; });
  add.long_lists(to.sum_lights, "many lights", "A thousand lights: the roundings of a running sum add up.",
                 [](Random& r) { return std::tuple{list_of(1000, [&] { return r.color(); })}; });
  add.hard(to.sum_lights, "very different lights", "Sixteen lights from 1e-9 to 1e9 in strength.", [](Random& r) {
    return std::tuple{list_of(16, [&] {
      const double strength = r.spread(-30, 30);
      return strength * r.color();
    })};
  });
  add.hard(to.sum_lights, "opposite signs",
           "Eight contributions, half of them taken away: what is left is a small difference.", [](Random& r) {
             return std::tuple{list_of(8, [&] {
               const double sign = r.sign();
               return sign * r.color();
             })};
           });

  add.ordinary(to.blocked, "Eight surfaces on the way to a light or behind it, a third of them glass.", [](Random& r) {
    const double distance = r.chance(0.2) ? infinity : r.between(0, 5);
    return std::tuple{list_of(8, [&] { return Crossing{r.between(0, 40), r.chance(1. / 3)}; }), distance};
  });
  add.hard(to.blocked, "surfaces next to the light",
           "Two surfaces as far away as the light but for up to two roundings: in float they are just as far.",
           [](Random& r) {
             const double distance = r.between(1, 20);
             return std::tuple{list_of(2,
                                       [&] {
                                         return Crossing{distance * (1 + r.whole(-2, 2) * 0x1p-52), r.chance(1. / 3)};
                                       }),
                               distance};
           });
}

}  // namespace

void add_light(TaskFamilies& to, const Families& add) {
  add_reflected_light(to, add);
  add_lights(to, add);
  add_sums_and_shadows(to, add);
}

}  // namespace raylab::bench
