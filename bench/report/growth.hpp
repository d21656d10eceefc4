#pragma once

#include "bench/report/unit.hpp"
#include "core/render/stage_table.hpp"

#include <vector>

namespace raylab::bench {

/// The work on the section "growth" of the report: what a frame costs over the number of spheres, lights, bounces, threads
/// and pixels, and what each feature costs a scene that has it. The scenes are made here (growth_scenes.hpp). `stages` must
/// outlive the units.
std::vector<Unit> growth_units(const Plan& plan, const StageTable& stages);

/// That section. What `results` lack, it lacks.
Json growth_report(const Plan& plan, const Results& results);

}  // namespace raylab::bench
