#pragma once

#include "core/results/results.hpp"

#include <filesystem>
#include <string>

namespace raylab {

/// A submission's results as an HTML page for its student: one file that needs no other, nor a network. Of the course's own
/// tests and images it holds their points alone. The images are read from `folder`, the submission's; one that is missing,
/// no PNG or outside the folder is shown as missing.
std::string student_page(const SubmissionResult& submission, const std::filesystem::path& folder);

}  // namespace raylab
