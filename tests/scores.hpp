#pragma once

// How near to the limit of docs/tolerance.md an image is: what docs/calibration.md and docs/mistakes.md are made from.
#include "tests/subjects.hpp"

#include <map>
#include <string>
#include <vector>

namespace raylab::test {

/// A mistake's image must be at least this far beyond the limit.
inline constexpr double least_of_wrong = 2;

/// The verdict's score as floats and in 8 bits: up to 1 the image is right.
struct Scores {
  double floats = 0;
  double bytes = 0;
};

/// Of an image with the subject's reference.
Scores scores_of(const Subject& subject, const Image& image);

/// All references but those of the hard scenes, by their stage.
using Subjects = std::map<int, std::vector<Subject>>;
Subjects subjects_by_stage();

/// "scene3, stage 5"
std::string title(const Subject& subject);

}  // namespace raylab::test
