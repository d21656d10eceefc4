#pragma once

#include "core/results/results.hpp"

#include <string>
#include <string_view>

namespace raylab {

/// The results.json that Gradescope's autograder reads: an entry for each task and each image. What is the course's own is
/// hidden from the student, in entries of their own. Points are those that count (core/results/counted.hpp).
std::string gradescope_json(const SubmissionResult& submission);

/// A valid results.json that gives no points and says `text`: written before grading begins, so that there is one whatever
/// happens, and replaced when grading is done.
std::string gradescope_failure(std::string_view text);

}  // namespace raylab
