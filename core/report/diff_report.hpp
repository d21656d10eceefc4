#pragma once

#include "core/image/diff.hpp"

#include <string>

namespace raylab {

/// What was compared with what, in words.
struct DiffTitle {
  std::string image;      ///< the file's name
  std::string reference;  ///< the file's name, or "scene3 at stage 5, reflections"
};

/// The comparison in a few lines for people, each ended by a line break.
std::string diff_text(const DiffTitle& title, const Comparison& comparison);

/// The comparison as JSON for programs: comparison_json(), and the names.
std::string diff_json(const DiffTitle& title, const Comparison& comparison);

}  // namespace raylab
