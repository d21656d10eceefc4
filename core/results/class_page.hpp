#pragma once

#include "core/results/class_summary.hpp"
#include "core/results/results.hpp"

#include <string>
#include <vector>

namespace raylab {

/// A class's results as an HTML page for the instructor: one file that needs no other, nor a network. It links to what
/// stands beside it: results.json, gradebook.csv and submissions/ID/report.html.
std::string class_page(const ClassResults& results, const std::vector<RosterEntry>& roster, const Seconds& seconds);

}  // namespace raylab
