#include "bench/report/inputs/families.hpp"

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace raylab::bench {
namespace {

// ---- 5 Reflections, 6 Refraction

/// The unit direction that arrives at a surface of normal `n` with this cosine, or this sine, of the angle between them.
Vec3 with_cosine(Random& random, const Vec3& n, double cosine) {
  return unit(std::sqrt((1 - cosine) * (1 + cosine)) * random.across(n) - cosine * n);
}
Vec3 with_sine(Random& random, const Vec3& n, double sine) {
  return unit(sine * random.across(n) - std::sqrt((1 - sine) * (1 + sine)) * n);
}

Hit at_mirror(Random& random, const Vec3& n, const Vec3& d) {
  return {random.between(1, 20), random.point(), d, n, {0, Side::outwards}};
}

void add_reflections(TaskFamilies& to, const Families& add) {
  const auto arriving = [](Random& r) {
    const Vec3 n = r.direction();
    return std::pair(-r.above(n), n);
  };
  add.ordinary(to.reflect, "Any direction that arrives at any surface.", [&](Random& r) {
    const auto [d, n] = arriving(r);
    return std::tuple{d, n};
  });
  add.hard(to.reflect, "grazing", "The direction is 1/32 to a millionth of a radian from the surface.", [](Random& r) {
    const Vec3 n = r.direction();
    return std::tuple{with_cosine(r, n, r.spread(-20, -5)), n};
  });
  add.ordinary(to.mirror_bounce, "Any direction that arrives at any surface, any weight.", [&](Random& r) {
    const auto [d, n] = arriving(r);
    return std::tuple{at_mirror(r, n, d), r.between(0, 1)};
  });
  add.hard(to.mirror_bounce, "grazing", "The direction is 1/32 to a millionth of a radian from the surface.", [](Random& r) {
    const Vec3 n = r.direction();
    const Vec3 d = with_cosine(r, n, r.spread(-20, -5));
    return std::tuple{at_mirror(r, n, d), r.between(0, 1)};
  });
  add.ordinary(to.go_on, "Bounces up to 10 and limits up to 10, weights down to 1e-30 and 0.", [](Random& r) {
    return std::tuple{r.whole(0, 10), r.whole(0, 10), r.chance(0.2) ? 0 : r.spread(-100, 0)};
  });
}

/// A sphere of glass, met from one side by a direction that `arrive` makes for the normal.
template <class Arrive>
Arguments<decltype(&contract::glass_bounces)> at_glass(Random& random, double n, Side side, Arrive arrive) {
  const Sphere sphere{random.point(), random.between(0.5, 3)};
  const Vec3 normal = random.direction();
  const double outwards = side == Side::outwards ? 1 : -1;
  const Vec3 p = sphere.center + outwards * sphere.radius * normal;
  return {sphere, n, {random.between(1, 20), p, arrive(normal), normal, {0, side}}};
}

double common_index(Random& random) { return random.between(1.1, 2.5); }
double near_one(Random& random) { return 1 + random.signed_spread(-20, -5); }
Side any_side(Random& random) { return random.chance(0.5) ? Side::outwards : Side::inwards; }

void add_glass(TaskFamilies& to, const Families& add) {
  const auto any = [](Random& r) { return [&r](const Vec3& normal) { return -r.above(normal); }; };
  const auto grazing = [](Random& r) {
    return [&r](const Vec3& normal) { return with_cosine(r, normal, r.spread(-20, -5)); };
  };
  const auto upright = [](Random& r) {
    return [&r](const Vec3& normal) { return with_sine(r, normal, r.spread(-26, -5)); };
  };
  /// At the angle from which on all is reflected, but for 1/32 to 1e-12 of its sine.
  const auto critical = [](Random& r, double sine) {
    return [&r, sine](const Vec3& normal) { return with_sine(r, normal, sine * (1 + r.signed_spread(-40, -5))); };
  };
  const auto from_outside = [&](auto index, auto arrive) {
    return [=](Random& r) {
      const double n = index(r);
      return at_glass(r, n, Side::outwards, arrive(r));
    };
  };
  const auto from_any_side = [&](auto index, auto arrive) {
    return [=](Random& r) {
      const double n = index(r);
      const Side side = any_side(r);
      return at_glass(r, n, side, arrive(r));
    };
  };
  const auto critical_outside = [=](Random& r) {
    const double n = r.between(0.4, 0.9);
    return at_glass(r, n, Side::outwards, critical(r, n));
  };
  const auto critical_inside = [=](Random& r) {
    const double n = common_index(r);
    return at_glass(r, n, Side::inwards, critical(r, 1 / n));
  };
  const std::string upright_text =
      "1/32 to 1e-8 of a radian from the normal: a cosine next to 1 says little of its angle, and one above 1 nothing.";
  const std::string grazing_text = "1/32 to a millionth of a radian from the surface: the angle is next to 90 degrees.";
  const std::string near_one_text = "A refractive index that differs from 1 by 1/32 to a millionth: the ray is hardly bent.";

  add.ordinary(to.through_sphere, "A refractive index from 1.1 to 2.5, any angle.", from_outside(common_index, any));
  add.hard(to.through_sphere, "at the critical angle",
           "An index below 1, and an angle next to the one from which on nothing enters: a root of a small difference.",
           critical_outside);
  add.hard(to.through_sphere, "index near 1", near_one_text, from_outside(near_one, any));
  add.hard(to.through_sphere, "grazing", grazing_text, from_outside(common_index, grazing));
  add.hard(to.through_sphere, "along the normal", upright_text, from_outside(common_index, upright));

  add.ordinary(to.schlick, "Any angle, a refractive index from 1.1 to 2.5.", [](Random& r) {
    return std::tuple{r.between(0, 1), common_index(r)};
  });
  add.hard(to.schlick, "grazing", "A cosine from 1/32 down to 1e-9: nearly all is reflected.", [](Random& r) {
    return std::tuple{r.spread(-30, -5), common_index(r)};
  });
  add.hard(to.schlick, "index near 1",
           "An index that differs from 1 by 1/32 to a millionth, at angles up to 60 degrees: little is reflected.",
           [](Random& r) {
             return std::tuple{r.between(0.5, 1), near_one(r)};
           });

  add.ordinary(to.glass_bounces, "A refractive index from 1.1 to 2.5, any angle, from outside and from inside.",
               from_any_side(common_index, any));
  add.hard(to.glass_bounces, "at the critical angle from outside",
           "An index below 1, and an angle next to the one from which on nothing enters.", critical_outside);
  add.hard(to.glass_bounces, "at the critical angle from inside",
           "An angle next to the one from which on nothing leaves: the cosine in air is a root of a small difference.",
           critical_inside);
  add.hard(to.glass_bounces, "index near 1", near_one_text, from_any_side(near_one, any));
  add.hard(to.glass_bounces, "grazing", grazing_text, from_outside(common_index, grazing));
  add.hard(to.glass_bounces, "along the normal", upright_text, from_any_side(common_index, upright));
}

// ---- 7 SSAA

void add_samples(TaskFamilies& to) {
  to.sample_positions.push_back({"ordinary", false, "The task takes nothing and always gives the same.", {{}}});
}

void add_means(TaskFamilies& to, const Families& add) {
  add.ordinary(to.resolve, "Four samples from 0 to 1.",
               [](Random& r) { return std::tuple{list_of(4, [&] { return r.color(); })}; });
  add.long_lists(to.resolve, "many samples", "1024 samples from 0 to 1: the roundings of a running sum add up.",
                 [](Random& r) { return std::tuple{list_of(1024, [&] { return r.color(); })}; });
  add.hard(to.resolve, "very different samples", "Sixteen samples from 1e-9 to 1 in brightness.", [](Random& r) {
    return std::tuple{list_of(16, [&] {
      const double brightness = r.spread(-30, 0);
      return brightness * r.color();
    })};
  });
}

}  // namespace

void add_bounces_and_samples(TaskFamilies& to, const Families& add) {
  add_reflections(to, add);
  add_glass(to, add);
  add_samples(to);
  add_means(to, add);
}

}  // namespace raylab::bench
