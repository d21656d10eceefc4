#pragma once

#include "core/render/stage_table.hpp"

namespace raylab {

/// The oracle's answers to the single tasks of the seven stages: docs/model.md's formulas with 493 bits, at exactly the
/// doubles that are given, and the double nearest to the result. Up to half a millisecond a call.
///
/// No double is exactly of length 1. So what a contract calls a unit vector is divided by its length first, exactly; but t
/// counts in the ray's direction as it is given, and a mirrored direction keeps its length. What is tangent or touching to
/// within 2^-370 of its scale counts as such: see `sign` in number.hpp.
///
/// Where a decision hangs on what has no answer (a number that is not finite, a direction of length 0), or 493 bits do not
/// reach (a finite shininess above 1e100, more than 360 degrees), a function throws std::domain_error. Elsewhere such
/// numbers give what they give in a sum or product: a NaN stays one.
StageTable oracle_table();

}  // namespace raylab
