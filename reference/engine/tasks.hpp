#pragma once

#include "core/render/stage_table.hpp"
#include "reference/engine/engine.hpp"

namespace raylab {

/// The fast engine's formulas as the single tasks of the seven stages: what its kernels compute, in `precision`, for one
/// number at a time (packs give the same bits). Inputs are rounded to that first; what the engine prepares in double for a
/// whole scene (unit vectors of planes and lights, the camera's axes, k_s) is so here.
///
/// The engine itself never asks for a normal by its point (task 2.3): it has the foot of the ray, which says more.
StageTable fast_table(Precision precision);

}  // namespace raylab
