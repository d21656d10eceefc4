#include "core/results/counted.hpp"

#include "core/scene/diagnostic.hpp"

#include <algorithm>
#include <cmath>

namespace raylab {
namespace {

double finite(double number) { return std::isfinite(number) ? number : 0; }

Points finite(const Points& points) { return {finite(points.got), finite(points.most)}; }

template <class Part>
Points counted_part(const Part& part) {
  const Points points = finite(part.points);
  return part.verdict == Verdict::infrastructure ? Points{points.most, points.most} : points;
}

/// What `parts` get beyond what grading gave them.
template <class Part>
double added(const std::vector<Part>& parts) {
  double sum = 0;
  for (const Part& part : parts) sum += counted_part(part).got - finite(part.points.got);
  return sum;
}

double added(const StageResult& stage) { return added(stage.tasks) + added(stage.images); }

Points counted(const SubmissionResult& submission, const Points& points, bool bonus) {
  Points sum = finite(points);
  for (const StageResult& stage : submission.stages)
    if (stage.bonus == bonus) sum.got += added(stage);
  return sum;
}

template <class Part>
bool any_failed(const std::vector<Part>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.verdict == Verdict::infrastructure; });
}

}  // namespace

Points counted(const TaskResult& task) { return counted_part(task); }

Points counted(const ImageResult& image) { return counted_part(image); }

Points counted(const StageResult& stage) {
  Points points = finite(stage.points);
  points.got += added(stage);
  return points;
}

Points counted_points(const SubmissionResult& submission) { return counted(submission, submission.points, false); }

Points counted_bonus(const SubmissionResult& submission) { return counted(submission, submission.bonus, true); }

bool needs_new_run(const StageResult& stage) { return any_failed(stage.tasks) || any_failed(stage.images); }

bool needs_new_run(const SubmissionResult& submission) {
  return std::any_of(submission.stages.begin(), submission.stages.end(),
                     [](const StageResult& stage) { return needs_new_run(stage); });
}

std::string points_text(double points) { return to_text(std::round(1000 * finite(points)) / 1000); }

std::string points_text(const Points& points) { return points_text(points.got) + " of " + points_text(points.most); }

}  // namespace raylab
