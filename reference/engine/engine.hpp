#pragma once

#include "core/render/engine.hpp"

#include <memory>

namespace raylab {

/// The type that the fast engine computes in.
enum class Precision { f32, f64 };

/// The fast engine: speed with known error. A scene is prepared once into one array for each kind of thing, so that what it
/// lacks costs nothing; the formulas are those that rounding harms least.
///
/// In double a pixel agrees with the oracle to about 1e-12 unless it hangs on a decision (an edge, a tie). The same row
/// gives the same bits in any thread. `scene` is copied. Throws std::invalid_argument for `f32` if a coordinate, color,
/// intensity or shininess (but infinity) is beyond 1e15 in size or a radius is below 1e-15: their squares would leave a
/// float's range. Directions and normals may have any length.
std::unique_ptr<Engine> make_fast(const Scene& scene, const Settings& settings, Precision precision);

}  // namespace raylab
