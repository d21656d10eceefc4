#pragma once

#include <string>
#include <vector>

namespace raylab::test {

/// An answer that was given in place of another one, both JSON; an error's text if there was none.
struct WrongAnswer {
  std::string arguments;
  std::string wanted;
  std::string got;
  std::string error;
};

/// What all these have in common, as far as numbers show it: a sign, a factor, an axis, a clamp, a miss for a hit. One or
/// more sentences; empty if nothing shows.
std::string common_pattern(const std::vector<WrongAnswer>& wrong);

}  // namespace raylab::test
