#pragma once

#include "core/results/results.hpp"

#include <string>
#include <string_view>

namespace raylab {

// The points that count, for every report. What raylab failed to judge (Verdict::infrastructure) costs no mark: it counts in
// full, says so, and is to be graded again. Numbers that are not finite count as 0.

/// Said wherever something counts in full because of this.
inline constexpr std::string_view new_run_note =
    "raylab failed here, not the submission: this counts in full until it is graded again.";

Points counted(const TaskResult& task);
Points counted(const ImageResult& image);
Points counted(const StageResult& stage);
Points counted_points(const SubmissionResult& submission);
Points counted_bonus(const SubmissionResult& submission);

/// Is there anything that raylab failed to judge?
bool needs_new_run(const StageResult& stage);
bool needs_new_run(const SubmissionResult& submission);

/// Points for people, to a thousandth and the same in every locale: "3.5", "5".
std::string points_text(double points);

/// "3.5 of 5".
std::string points_text(const Points& points);

}  // namespace raylab
