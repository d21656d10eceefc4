#pragma once

#include "core/grade/class_folder.hpp"
#include "core/results/results.hpp"

namespace raylab {

/// Writes all that is made of a folder's finished results: results.json, gradebook.csv, junit.xml, the class's page and a
/// page for each student. Returns the results. Throws std::runtime_error.
ClassResults write_reports(const ClassFolder& folder);

}  // namespace raylab
