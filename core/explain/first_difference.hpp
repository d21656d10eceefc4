#pragma once

#include "core/explain/recording.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// Asks somebody's task: arguments and result are JSON. Whatever it throws is an answer too.
using AskTask = std::function<std::string(const TaskInfo& task, const std::string& arguments)>;

/// A call that somebody answers in another way.
struct Difference {
  RecordedCall call;  ///< as it was recorded
  std::string got;    ///< the other answer, JSON; empty if there is none
  std::string error;  ///< why there is none
};

/// Are these answers to one call the same, but for what right programs differ by: rounding, in float at worst, and a start
/// of a ray that is moved off the surface? JSON.
bool answers_agree(const std::string& wanted, const std::string& got);

/// The first recorded call that `ask` answers differently, given the very same bits.
std::optional<Difference> first_difference(const Recording& recording, const AskTask& ask);

}  // namespace raylab
