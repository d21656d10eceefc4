// The solution's files as they stand, once more, in the driver's own translation unit.

#include "bench/inlined_solution.hpp"

#include "core/render/driver.hpp"
#include "reference/solution/01_rays.cpp"
#include "reference/solution/02_intersections.cpp"
#include "reference/solution/03_blinn_phong.cpp"
#include "reference/solution/04_shadows.cpp"
#include "reference/solution/05_reflections.cpp"
#include "reference/solution/06_refraction.cpp"
#include "reference/solution/07_ssaa.cpp"
#include "stages/stages.hpp"

namespace raylab {
namespace {

/// A table whose functions are constants.
struct InlinedTable {
#define RAYLAB_MEMBER(label, function, summary, example) static constexpr auto function = &inlined::function;
  RAYLAB_TASKS(RAYLAB_MEMBER)
#undef RAYLAB_MEMBER
};

}  // namespace

std::unique_ptr<Engine> make_inlined(const Scene& scene, const Settings& settings) {
  return std::make_unique<DriverEngine<InlinedTable>>(scene, settings, InlinedTable{}, std::vector<RayFilter>{});
}

}  // namespace raylab
