#pragma once

#include "core/render/stage_table.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace raylab::test {

/// Where a mistake shows, beside its task's unit tests.
enum class Shows : std::uint8_t {
  in_images,      ///< in an image of its stage or, if that stage's cannot show it, of a later one
  in_floats,      ///< the same, but not in 8 bits
  in_unit_tests,  ///< in no image
  nowhere,        ///< not even in unit tests: it changes nothing, and is no mistake
};

/// A wrong answer to a task, of the kind that students really give.
struct Mistake {
  std::string_view task;          ///< "5.3"
  std::string_view name;          ///< "one bounce too many"
  void (*put_into)(StageTable&);  ///< into a right table; tasks that build on the wrong one go wrong with it
  Shows shows = Shows::in_images;
  std::string_view why = {};  ///< why it shows in less than all images: what hides it or, if nowhere, the proof
};

/// `right` with the mistake in it.
StageTable with(const Mistake& mistake, const StageTable& right);

/// All of them, in the order of the tasks.
std::span<const Mistake> known_mistakes();

}  // namespace raylab::test
