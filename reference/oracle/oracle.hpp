#pragma once

#include "core/render/engine.hpp"

#include <memory>

namespace raylab {

/// The truth that all else is measured against: MODEL.md's formulas as printed, one scalar ray at a time, every geometry
/// asked. Slow: about a millisecond a pixel where a double takes a microsecond.
///
/// Each pixel is computed with 113 and with 237 bits. Where the two clamped colours agree to 1e-25 in every component, the
/// double nearest the finer one is returned. Where they do not, the question that the pixel asks (which of two surfaces is
/// nearer, on which side of an edge it lies) is closer than 113 bits can tell, and the pixel is three quiet NaNs: never
/// silently wrong. Situations that are exactly tangent, tied or touching are decided as MODEL.md says: see `sign`.
///
/// `scene` is copied. Rays are counted once, not once a precision.
std::unique_ptr<Engine> make_oracle(const Scene& scene, const Settings& settings);

}  // namespace raylab
