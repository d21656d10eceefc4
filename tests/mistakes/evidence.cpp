#include "tests/mistakes/evidence.hpp"

#include "core/render/stages_engine.hpp"

#include <algorithm>
#include <stdexcept>

namespace raylab::test {

double counted(const Mistake& mistake, const Scores& scores) {
  return mistake.shows == Shows::in_floats ? scores.floats : std::min(scores.floats, scores.bytes);
}

Evidence evidence(const Mistake& mistake, const StageTable& right, const Subject& subject) {
  const StageTable table = with(mistake, right);
  try {
    const Image image = rendered(subject, [&](const Scene& s, const Settings& c) { return make_stages(s, c, table); });
    return {title(subject), scores_of(subject, image)};
  } catch (const std::runtime_error&) {
    return {title(subject), {}};
  }
}

Evidence best_evidence(const Mistake& mistake, const StageTable& right, const Subjects& subjects, bool quick) {
  Evidence best;
  const auto shown = [&] { return counted(mistake, best.scores) >= least_of_wrong; };
  for (auto stage = subjects.lower_bound(stage_of(mistake.task)); stage != subjects.end() && !shown(); ++stage)
    for (const Subject& subject : stage->second) {
      const Evidence next = evidence(mistake, right, subject);
      if (counted(mistake, next.scores) > counted(mistake, best.scores)) best = next;
      if (quick && shown()) break;
    }
  return best;
}

}  // namespace raylab::test
