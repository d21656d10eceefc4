#pragma once

#include "core/render/engine.hpp"
#include "core/scene/scene.hpp"

#include <memory>
#include <vector>

namespace raylab::bench {

/// Choices that the model leaves to whoever writes a renderer: each gives a right image, with roundings of its own or as one
/// of the "Accepted variants" (docs/errata.md).
struct Variant {
  bool single_precision = false;  ///< all in float, else all in double

  /// Shadow rays start at p + shift L, 0 to 0.1. With 0 a point's own geometry is skipped outwards; else it is tested like
  /// any other, blocked means met at 0 <= t < distance - shift, and a light at distance <= shift is never blocked.
  double shadow_shift = 0;
  double bounce_shift = 0;  ///< reflected and exit rays start at p + shift d, 0 to 0.001, in the same way

  double lift = 0;  ///< reflected and exit rays start at p + lift N instead, 0 to 0.001

  bool clamp_each = false;        ///< L.N and H.N are each clamped by itself: a highlight needs no L.N > 0 (D9)
  bool power_by_exp_log = false;  ///< (H.N)^alpha as exp(alpha log(H.N))
  bool lights_backwards = false;  ///< sums the lights in the opposite order
  bool black_rim = false;         ///< total reflection at the exit by rounding alone: black, else phi_2 = theta_1 (D16)

  enum class Roots {
    textbook,   ///< b^2 - 4ac with a = d.d
    half_b,     ///< b^2 - c for a unit direction
    geometric,  ///< by the distance of the sphere's center from the ray
  } roots = Roots::textbook;

  enum class Glass {
    angles,   ///< theta_1, theta_2, phi_1, phi_2 by acos and asin
    vectors,  ///< two refractions of vectors
    closed,   ///< the exit ray at once, from the symmetry of the sphere
  } glass = Glass::angles;
};

/// One compilation of the renderer.
struct HandoutBuild {
  const char* name;
  std::unique_ptr<Engine> (*make)(const Scene&, const Settings&, const Variant&);
};

/// The renderer as compiled with several sets of optimization flags, as far as this machine can run them: the whole model
/// (docs/model.md) in one plain file, as a student would write it from the handout, with nothing taken from the reference
/// implementations.
std::vector<HandoutBuild> handout_builds();

}  // namespace raylab::bench
