#pragma once

#include "core/render/stage_table.hpp"

#include <span>
#include <string_view>

namespace raylab::test {

/// A wrong answer to a task, of the kind that students really give.
struct Mistake {
  std::string_view task;          ///< "5.3"
  std::string_view name;          ///< "one bounce too many"
  void (*put_into)(StageTable&);  ///< into a right table; tasks that build on the wrong one go wrong with it
};

std::span<const Mistake> known_mistakes();

}  // namespace raylab::test
