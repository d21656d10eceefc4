#pragma once

#include "core/results/results.hpp"

#include <string>
#include <vector>

namespace raylab {

/// A gradebook as CSV: a line for each submission with its name from the roster, its points and bonus, the points of each
/// stage, the verdict on each task, and whether raylab failed somewhere so that it is to be graded again. No cell is a
/// formula to a spreadsheet.
std::string gradebook_csv(const ClassResults& results, const std::vector<RosterEntry>& roster);

}  // namespace raylab
