#pragma once

namespace raylab {

/// How a ray's distance from a sphere's center is worked out.
enum class SphereFormula {
  foot,      ///< from the vector between the center and the ray's nearest point; near the surface without error
  textbook,  ///< b^2 - 4ac, with c = |o - C|^2 - R^2
};

/// How (H.N)^alpha is.
enum class PowerFormula {
  log1p,   ///< near the peak from the sine, which knows a small angle best
  cosine,  ///< exp(alpha log(H.N)) of the rounded cosine
};

/// Which formulas the fast engine computes with. The first of each are the engine's own; the others are what they are
/// measured against.
struct Formulas {
  SphereFormula sphere = SphereFormula::foot;
  PowerFormula power = PowerFormula::log1p;

  bool operator==(const Formulas&) const = default;
};

}  // namespace raylab

/// Around each compilation of the kernel stands a namespace that says with which formulas.
namespace raylab::fast {
namespace foot_log1p {
inline constexpr Formulas formulas{};
}
namespace foot_cosine {
inline constexpr Formulas formulas{SphereFormula::foot, PowerFormula::cosine};
}
namespace textbook_log1p {
inline constexpr Formulas formulas{SphereFormula::textbook, PowerFormula::log1p};
}
namespace textbook_cosine {
inline constexpr Formulas formulas{SphereFormula::textbook, PowerFormula::cosine};
}
}  // namespace raylab::fast
