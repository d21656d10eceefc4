#include "tests/mistakes/building_blocks.hpp"
#include "tests/mistakes/stages.hpp"

namespace raylab::test {

std::vector<Mistake> mistakes_in_shadows() {
  return {
      {"4.1", "no shadows", [](StageTable& t) { t.blocked = [](std::span<const Crossing>, double) { return false; }; }},
      {"4.1", "glass blocks",
       [](StageTable& t) {
         t.blocked = [](std::span<const Crossing> all, double distance) {
           return std::any_of(all.begin(), all.end(), [&](const Crossing& c) { return c.t < distance; });
         };
       }},
      {"4.1", "only glass blocks",
       [](StageTable& t) {
         t.blocked = [](std::span<const Crossing> all, double distance) {
           return std::any_of(all.begin(), all.end(), [&](const Crossing& c) { return c.transparent && c.t < distance; });
         };
       }},
      {"4.1", "blocked only if everything blocks",
       [](StageTable& t) {
         t.blocked = [](std::span<const Crossing> all, double distance) {
           return std::all_of(all.begin(), all.end(), [&](const Crossing& c) { return !c.transparent && c.t < distance; });
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
      {"4.1", "everything blocked",
       [](StageTable& t) { t.blocked = [](std::span<const Crossing>, double) { return true; }; }},
      {"4.1", "the last geometry decides",
       [](StageTable& t) {
         t.blocked = [](std::span<const Crossing> all, double distance) {
           bool answer = false;
           for (const Crossing& c : all) answer = !c.transparent && c.t < distance;
           return answer;
         };
       },
       Shows::in_unit_tests, "no scene lists glass, or what is past the light, after what blocks it"},
      {"4.1", "glass before a stone saves from its shadow",
       [](StageTable& t) {
         t.blocked = [](std::span<const Crossing> all, double distance) {
           const auto nearest = std::min_element(all.begin(), all.end(), [](auto& a, auto& b) { return a.t < b.t; });
           return nearest != all.end() && !nearest->transparent && nearest->t < distance;
         };
       },
       Shows::in_unit_tests, "in no scene does glass stand between a blocker and its shadow"},
      {"4.1", "t <= distance",
       [](StageTable& t) {
         t.blocked = [](std::span<const Crossing> all, double distance) {
           return std::any_of(all.begin(), all.end(), [&](const Crossing& c) { return !c.transparent && c.t <= distance; });
         };
       },
       Shows::in_unit_tests, "the driver leaves out the surface that a light lies on, since rounding would decide there"},
  };
}

}  // namespace raylab::test
