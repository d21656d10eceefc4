#pragma once

#include "core/results/results.hpp"

#include <string>

namespace raylab {

/// The results as JUnit XML, for the instructor: a test suite for each submission, a test case for each task and each image.
/// An answer that is wrong is a failure; what could not be judged (it does not compile, it crashed, raylab failed) an error;
/// what is not written is skipped. Valid XML 1.0 whatever the texts hold.
std::string junit_xml(const ClassResults& results);

}  // namespace raylab
