#pragma once

#include "core/render/stage_table.hpp"
#include "reference/engine/engine.hpp"

namespace raylab::bench {

/// The tasks of the seven stages as a textbook or the handout writes them: b^2 - 4ac for a sphere, the power of a cosine for
/// a highlight, angles by acos and asin for glass. What the other implementations' care is measured against.
///
/// Inputs are rounded to `precision` first, and everything is computed in it. Decisions that docs/model.md asks for are
/// there; there is no guard against what rounding does: an asin of more than 1 gives NaN.
StageTable textbook_table(Precision precision);

}  // namespace raylab::bench
