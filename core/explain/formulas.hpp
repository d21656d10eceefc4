#pragma once

#include <string_view>

namespace raylab {

/// What a task computes, in a line, and where it is explained.
struct Formula {
  std::string_view formula;  ///< empty for a task of an added stage
  std::string_view handout;  ///< "section 5, equation 4"
};

Formula formula_of(std::string_view task_label);

}  // namespace raylab
