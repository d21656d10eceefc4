#include "tests/mistakes/mistakes.hpp"

#include "tests/mistakes/stages.hpp"

#include <vector>

namespace raylab::test {

StageTable with(const Mistake& mistake, const StageTable& right) {
  StageTable table = right;
  mistake.put_into(table);
  return table;
}

std::span<const Mistake> known_mistakes() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> joined;
    for (const auto& mistakes_in_stage :
         {mistakes_in_rays, mistakes_in_intersections, mistakes_in_blinn_phong, mistakes_in_shadows, mistakes_in_reflections,
          mistakes_in_refraction, mistakes_in_ssaa})
      for (const Mistake& mistake : mistakes_in_stage()) joined.push_back(mistake);
    return joined;
  }();
  return all;
}

}  // namespace raylab::test
