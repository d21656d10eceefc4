#pragma once

#include "core/results/results.hpp"

namespace raylab {

/// What a student may see of a submission, in plain_text() and with the points that count: nothing of the course's own tests
/// and images, no notes to the instructor, and no hash that a seed could be guessed by.
SubmissionResult shown_to_student(const SubmissionResult& submission);

/// The points of the course's own images, which a student sees as this sum alone.
Points hidden_points(const StageResult& stage);

}  // namespace raylab
