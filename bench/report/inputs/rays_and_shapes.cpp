#include "bench/report/inputs/families.hpp"

#include <optional>
#include <tuple>

namespace raylab::bench {
namespace {

// ---- 1 Rays

Arguments<decltype(&contract::camera_ray)> any_pixel(Random& random, const Camera& camera) {
  const double x = random.whole(-319, 320), y = random.whole(-239, 240);
  return {camera, 640, 480, x, y, random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
}

void add_rays(TaskFamilies& to, const Families& add) {
  add.ordinary(to.camera_ray, "Any camera with half a field of view of 10 to 80 degrees, any pixel of 640 x 480.",
               [](Random& r) {
                 return any_pixel(r, {r.point(), r.point(), r.point(), r.between(10, 80)});
               });
  add.hard(to.camera_ray, "narrow field of view",
           "Half a field of view of a millionth to an eighth of a degree: all rays are nearly the same.", [](Random& r) {
             return any_pixel(r, {r.point(), r.point(), r.point(), r.spread(-20, -3)});
           });
  add.hard(to.camera_ray, "field of view near 90 degrees",
           "Half a field of view that is 1 to 1/4096 degree short of 90, seen in the middle of the image, where the tangent "
           "counts: it grows without bound, and radians have rounded away what is missing.",
           [](Random& r) {
             const double missing = r.spread(-12, 0);
             const Camera camera{r.point(), r.point(), r.point(), 90 - missing};
             const double pixel = missing / 115;  // one in the picture is 2 tan(theta) = 115 / missing wide
             const double dx = r.between(-1, 1) * pixel, dy = r.between(-1, 1) * pixel;
             return std::tuple{camera, 1, 1, 0.5, 0.5, dx, dy};
           });
  add.hard(
      to.camera_ray, "up nearly parallel to facing",
      "The two are 1/8 to a millionth of a radian apart: their cross product cancels, and a small error turns the picture.",
      [](Random& r) {
        const Vec3 facing = r.point();
        return any_pixel(r, {r.point(), facing, r.tilted(unit(facing), r.spread(-20, -3)), r.between(10, 80)});
      });
  add.hard(to.camera_ray, "vectors of any length",
           "Facing and up are 1e-30 to 1e30 long: in float their squares vanish or overflow.", [](Random& r) {
             const Vec3 facing = r.vector(-100, 100), up = r.vector(-100, 100);
             return any_pixel(r, {r.point(), facing, up, r.between(10, 80)});
           });
}

// ---- 2 Intersections

void add_planes(TaskFamilies& to, const Families& add) {
  add.ordinary(to.plane_hit, "A ray and a plane anywhere within 10 of the origin; half of them miss.", [](Random& r) {
    return std::tuple{Ray{r.point(), r.direction(), {}}, Plane{r.point(), r.vector(-1, 1)}};
  });
  add.hard(
      to.plane_hit, "nearly parallel",
      "The ray rises or sinks by 1/8 to a millionth of its length: the product of its direction and the normal cancels.",
      [](Random& r) {
        const Vec3 n = r.direction(), d = r.raised(n, r.signed_spread(-20, -3));
        return std::tuple{Ray{r.point(), d, {}}, Plane{r.point(), n}};
      });
  add.hard(to.plane_hit, "far point",
           "The plane is near, but given by a point that is 1e3 to 1e8 away: the height above it is a small difference.",
           [](Random& r) {
             const Vec3 n = r.direction(), along = r.across(n);
             return std::tuple{Ray{r.point(), r.direction(), {}}, Plane{r.spread(10, 26) * along, n}};
           });
  add.hard(to.plane_hit, "starts close to the plane",
           "The ray starts 1/32 to 1e-9 from the plane, or on its other side if rounding has put it there.", [](Random& r) {
             const Vec3 n = r.direction(), c = r.point(), along = r.across(n);
             const double aside = r.between(0, 10), height = r.spread(-30, -5);
             return std::tuple{Ray{c + aside * along + height * n, -r.above(n), {}}, Plane{c, n}};
           });
}

/// How a ray passes a sphere.
struct Passing {
  double miss;      ///< how far from its center, in radii
  double distance;  ///< from the ray's start to the place where it is nearest to the center
};

Ray passing(Random& random, const Sphere& sphere, Passing at) {
  const Vec3 d = random.direction();
  return {sphere.center - at.distance * d + at.miss * sphere.radius * random.across(d), d, {}};
}

void add_spheres(TaskFamilies& to, const Families& add) {
  add.ordinary(to.sphere_hit,
               "A sphere of radius 1/2 to 3 within 10 of the origin, before, around or behind the ray's start; some miss.",
               [](Random& r) {
                 const Sphere sphere{r.point(), r.between(0.5, 3)};
                 return std::tuple{passing(r, sphere, {r.between(0, 1.3), r.between(-5, 20)}), sphere};
               });
  add.hard(to.sphere_hit, "far tiny spheres",
           "Seen from 32 to 1e7 radii away: b^2 - 4ac is a small difference of squares of the distance.", [](Random& r) {
             const Sphere sphere{r.point(1), r.spread(-10, 0)};
             return std::tuple{passing(r, sphere, {r.between(0, 1.1), sphere.radius * r.spread(5, 23)}), sphere};
           });
  add.hard(to.sphere_hit, "giant sphere from its surface",
           "A floor of radius 1e3 to 1e9, seen from at most 8 above it: |f|^2 - R^2 is a small difference of large squares.",
           [](Random& r) {
             const Vec3 up = r.direction();
             const double radius = r.spread(10, 30);
             const Vec3 d = r.raised(up, r.between(-1, 0.1));
             return std::tuple{Ray{r.spread(-10, 3) * up, d, {}}, Sphere{-radius * up, radius}};
           });
  add.hard(to.sphere_hit, "nearly tangent",
           "The ray passes the center at a radius, but for 1/8 to 1e-12 of it: what is under the root cancels.",
           [](Random& r) {
             const Sphere sphere{r.point(), r.between(0.5, 3)};
             return std::tuple{passing(r, sphere, {1 + r.signed_spread(-40, -3), r.between(5, 20)}), sphere};
           });
  add.hard(to.sphere_hit, "starts on the surface",
           "The ray starts on the sphere but for rounding, which decides whether it is met there at a tiny distance.",
           [](Random& r) {
             const Sphere sphere{r.point(), r.between(0.5, 3)};
             return std::tuple{Ray{sphere.center + sphere.radius * r.direction(), r.direction(), {}}, sphere};
           });
  add.hard(
      to.sphere_hit, "far from the origin",
      "Ray and sphere are next to one another, and 64 to 1e6 from the world's origin: coordinates have fewer bits to spare.",
      [](Random& r) {
        const Sphere sphere{r.vector(6, 20), r.between(0.5, 3)};
        return std::tuple{passing(r, sphere, {r.between(0, 0.95), r.between(5, 20)}), sphere};
      });

  add.ordinary(to.sphere_normal, "A point of a sphere of radius 1/2 to 3 within 10 of the origin.", [](Random& r) {
    const Sphere sphere{r.point(), r.between(0.5, 3)};
    return std::tuple{sphere, sphere.center + sphere.radius * r.direction()};
  });
  add.hard(to.sphere_normal, "small and far from the origin",
           "The sphere's radius is 1/4 to 1e-5 of its distance from the world's origin: point and center nearly cancel.",
           [](Random& r) {
             const Sphere sphere{10. * r.direction(), 10 * r.spread(-16, -2)};
             return std::tuple{sphere, sphere.center + sphere.radius * r.direction()};
           });

  const auto distance = [](Random& r) { return r.chance(0.3) ? std::nullopt : std::optional(r.between(0, 100)); };
  add.ordinary(to.nearest_hit, "Eight geometries, of which a third is missed.", [&](Random& r) {
    return std::tuple{list_of(8, [&] { return Candidate{0, distance(r)}; })};
  });
  add.hard(to.nearest_hit, "nearly equal",
           "Eight distances that are the same but for up to two roundings: in float they are all equal, and the first wins.",
           [](Random& r) {
             const double t = r.between(1, 100);
             return std::tuple{list_of(8, [&] { return Candidate{0, t * (1 + r.whole(-2, 2) * 0x1p-52)}; })};
           });
}

}  // namespace

void add_rays_and_shapes(TaskFamilies& to, const Families& add) {
  add_rays(to, add);
  add_planes(to, add);
  add_spheres(to, add);
}

}  // namespace raylab::bench
