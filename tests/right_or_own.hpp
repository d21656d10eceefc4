#pragma once

// A task may ask another one of its stage: 5.2 asks 5.1. A mistake in 5.1 must then fail the tests of 5.1 and not those of a
// 5.2 that is right. So the tests of such a task say what they expect as a function of the tasks that it may ask.
#include "tests/support.hpp"

#include <exception>

namespace raylab::test {

/// The tasks that others of their stage may ask, as the handout prints them: 3.1, 3.2, 5.1, 6.1 and 6.2. The others are
/// null.
const StageTable& printed_tasks();

/// What a task answers that is right by the printed tasks or, of a submission, by the submission's own.
template <class Expected>
struct RightOrOwn {
  Expected expected;  ///< of the StageTable that is asked
};

/// CHECK(bounce.direction == right_or_own([&](const StageTable& asked) { return within(1e-16, asked.reflect(d, n)); }))
template <class Expected>
RightOrOwn<Expected> right_or_own(const Expected& expected) {
  return {expected};
}

template <class Answer, class Expected>
bool operator==(const Answer& actual, const RightOrOwn<Expected>& either) {
  if (actual == either.expected(printed_tasks())) return true;
  if (!judging_submission()) return false;
  try {
    return actual == either.expected(table());
  } catch (const std::exception&) {  // the submission's own has no answer
    return false;
  }
}

}  // namespace raylab::test

template <class Expected>
struct Catch::StringMaker<raylab::test::RightOrOwn<Expected>> {
  static std::string convert(const raylab::test::RightOrOwn<Expected>& either) {
    return Catch::Detail::stringify(either.expected(raylab::test::printed_tasks()));
  }
};
