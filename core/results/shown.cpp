#include "core/results/shown.hpp"

#include "core/results/counted.hpp"
#include "core/results/plain_text.hpp"

#include <algorithm>

namespace raylab {
namespace {

void hide(TaskResult& task) {
  task.points = counted(task);
  task.hidden_passed = 0;
  task.hidden_failed.clear();
  task.mistake.clear();
}

void hide(StageResult& stage) {
  stage.points = counted(stage);
  std::erase_if(stage.images, [](const ImageResult& image) { return image.hidden; });
  for (TaskResult& task : stage.tasks) hide(task);
}

}  // namespace

SubmissionResult shown_to_student(const SubmissionResult& submission) {
  SubmissionResult shown = with_plain_text(submission);
  shown.points = counted_points(submission);
  shown.bonus = counted_bonus(submission);
  shown.inputs.clear();
  shown.notes.clear();
  for (StageResult& stage : shown.stages) hide(stage);
  return shown;
}

Points hidden_points(const StageResult& stage) {
  Points sum;
  for (const ImageResult& image : stage.images)
    if (image.hidden) sum += counted(image);
  return sum;
}

}  // namespace raylab
