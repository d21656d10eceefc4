#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {
namespace {

template <Vec3 (*reflect)(const Vec3&, const Vec3&)>
void put_reflect(StageTable& table) {
  table.reflect = reflect;
  table.mirror_bounce = [](const Hit& hit, double k_s) {
    return Bounce{{hit.point, reflect(hit.direction, hit.normal), hit.leaves}, k_s};
  };
}
Vec3 equation_on_the_cast_ray(const Vec3& d, const Vec3& n) { return 2 * dot(d, n) * n - d; }
Vec3 half_way(const Vec3& d, const Vec3& n) { return unit(d - 1.9 * dot(d, n) * n); }

Vec3 once(const Vec3& d, const Vec3& n) { return d - dot(d, n) * n; }
Vec3 plus_for_minus(const Vec3& d, const Vec3& n) { return d + 2 * dot(d, n) * n; }
Vec3 straight_on(const Vec3& d, const Vec3&) { return d; }
Vec3 straight_back(const Vec3& d, const Vec3&) { return -d; }

}  // namespace

std::vector<Mistake> mistakes_in_reflections() {
  return {
      {"5.1", "equation 4 on the cast ray", put_reflect<equation_on_the_cast_ray>},
      {"5.1", "1.9 for 2", put_reflect<half_way>},
      {"5.1", "once for twice", put_reflect<once>},
      {"5.1", "plus for minus: d + 2 (d.n) n", put_reflect<plus_for_minus>},
      {"5.1", "straight on", put_reflect<straight_on>},
      {"5.1", "straight back", put_reflect<straight_back>},
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
      {"5.2", "1 - k_s",
       [](StageTable& t) {
         t.mirror_bounce = [](const Hit& hit, double k_s) {
           return Bounce{{hit.point, right_reflect(hit.direction, hit.normal), hit.leaves}, 1 - k_s};
         };
       }},
      {"5.2", "the ray leaves to the wrong side",
       [](StageTable& t) {
         t.mirror_bounce = [](const Hit& hit, double k_s) {
           const Side other = hit.leaves.side == Side::outwards ? Side::inwards : Side::outwards;
           return Bounce{{hit.point, right_reflect(hit.direction, hit.normal), {hit.leaves.geometry, other}}, k_s};
         };
       }},
      {"5.2", "every surface taken for a floor",
       [](StageTable& t) {
         t.mirror_bounce = [](const Hit& hit, double k_s) {
           return Bounce{{hit.point, {hit.direction.x, -hit.direction.y, hit.direction.z}, hit.leaves}, k_s};
         };
       }},
      {"5.2", "the ray starts 0.1 off the surface",
       [](StageTable& t) {
         t.mirror_bounce = [](const Hit& hit, double k_s) {
           const Vec3 direction = right_reflect(hit.direction, hit.normal);
           return Bounce{{hit.point + 0.1 * direction, direction, hit.leaves}, k_s};
         };
       }},
      {"5.3", "one bounce too many",
       [](StageTable& t) { t.go_on = [](int b, int most, double w) { return b <= most + 1 && w != 0; }; }},
      {"5.3", "one bounce too few",
       [](StageTable& t) { t.go_on = [](int b, int most, double w) { return b < most && w != 0; }; }},
      {"5.3", "no limit but 40", [](StageTable& t) { t.go_on = [](int b, int, double w) { return b <= 40 && w != 0; }; }},
      {"5.3", "faint reflections not traced: a weight below 0.05",
       [](StageTable& t) { t.go_on = [](int b, int most, double w) { return b <= most && w > 0.05; }; }},
      {"5.3", "or for and: what has a weight is traced without end",
       [](StageTable& t) { t.go_on = [](int b, int most, double w) { return b <= most || (w != 0 && b <= 40); }; }},
      {"5.3", "rays of weight 0 traced", [](StageTable& t) { t.go_on = [](int b, int most, double) { return b <= most; }; },
       Shows::in_unit_tests, "what such a ray brings is multiplied by 0; it only takes time"},
  };
}

}  // namespace raylab::test
