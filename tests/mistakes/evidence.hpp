#pragma once

#include "tests/mistakes/mistakes.hpp"
#include "tests/scores.hpp"

#include <string>

namespace raylab::test {

/// An image of a mistake's table, and its scores.
struct Evidence {
  std::string scene = "-";  ///< "scene3, stage 5"
  Scores scores = {-1, -1};
};

/// The score that must be beyond the limit: the smaller one, or that of floats where 8 bits hide the mistake.
double counted(const Mistake& mistake, const Scores& scores);

/// What the mistake makes of one subject. An image that the driver refuses to make has the scores 0.
Evidence evidence(const Mistake& mistake, const StageTable& right, const Subject& subject);

/// What shows it best: of the references of the mistake's stage or, where those cannot show it (a normal, say, in a picture
/// of flat colors), of the next stage that can. Stops at the first that shows it, if `quick`.
Evidence best_evidence(const Mistake& mistake, const StageTable& right, const Subjects& subjects, bool quick = false);

}  // namespace raylab::test
