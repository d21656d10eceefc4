#pragma once

#include "bench/report/unit.hpp"
#include "core/render/stage_table.hpp"

#include <vector>

namespace raylab::bench {

/// The section "kernels": each task's function by itself, as the textbook, the solution and the fast engine have it. What a
/// call takes, and how far the results are from the oracle's, for each family of inputs (task_inputs.hpp).
///
/// One unit for each family, "kernels/2.2/far tiny spheres"; its result is the family's entry in the report. All of them
/// take about 10 s in a quick run, and a minute and a half in a full one.
/// `solution`: the implementation that is measured beside the textbook's and the engine's.
std::vector<Unit> kernel_units(const Plan& plan, const StageTable& solution);

/// The section, of those families that have been measured: tasks in order, docs/bench.md has its format.
Json kernel_report(const Results& results);

}  // namespace raylab::bench
