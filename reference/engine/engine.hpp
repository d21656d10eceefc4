#pragma once

#include "core/render/engine.hpp"
#include "reference/engine/formulas.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// The type that the fast engine computes in.
enum class Precision { f32, f64 };

/// How the fast engine is to work. Nothing of this but precision and formulas changes a bit of the image.
struct FastOptions {
  Precision precision = Precision::f64;
  std::string simd = {};  ///< the instruction set, a name of simd_targets(); empty: default_simd_target()
  bool hierarchy = true;  ///< false: ask every sphere, however many there are
  unsigned threads = 1;   ///< to prepare the scene with
  Formulas formulas = {};
};

/// An instruction set that this machine can run the engine with.
struct SimdTarget {
  std::string_view name;     ///< "avx512", "avx2", "sse4", "neon", or "scalar": one number at a time
  int lanes_f32, lanes_f64;  ///< how many numbers it computes with at a time
};

/// The instruction sets that this machine and this build have, the widest first; "scalar" is always the last one.
/// With other formulas than the engine's own there are none if the build leaves those out.
std::vector<SimdTarget> simd_targets(Formulas formulas = {});

/// The widest one, or the one that the environment variable RAYLAB_SIMD names. Throws std::invalid_argument where it names
/// one that is not among simd_targets().
std::string_view default_simd_target();

/// The fast engine: speed with known error. A scene is prepared once into one array for each kind of thing, so that what it
/// lacks costs nothing; the formulas are those that rounding harms least; packs of pixels run through them together.
///
/// In double a pixel agrees with the oracle to about 1e-12 unless it hangs on a decision (an edge, a tie). The same row
/// gives the same bits in any thread and with any instruction set. `scene` is copied. Throws std::invalid_argument for `f32`
/// if a coordinate, color, intensity or shininess (but infinity) is beyond 1e15 in size or a radius is below 1e-15: their
/// squares would leave a float's range. Directions and normals may have any length. Throws it, too, for a `simd` that is
/// not among simd_targets(options.formulas), and for more than 100 bounces.
std::unique_ptr<Engine> make_fast(const Scene& scene, const Settings& settings, const FastOptions& options);

}  // namespace raylab
