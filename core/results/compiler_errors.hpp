#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// An error that a compiler reports at a place.
struct CompilerError {
  int line = 0;
  int column = 0;
  std::string text;
};

/// The errors among what g++ or clang++ says (FILE:LINE:COLUMN: error: TEXT) that are in `file`, by whatever path.
std::vector<CompilerError> compiler_errors(std::string_view messages, std::string_view file);

}  // namespace raylab
