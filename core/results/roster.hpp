#pragma once

#include "core/results/results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// roster.csv: a line "id,name", and one for each entry. A name may be any bytes: a backslash, what is not plain text and
/// what a spreadsheet would take for the start of a formula are written as in \x3d.
std::string roster_csv(const std::vector<RosterEntry>& roster);

/// And back, from a file that a person may have written. Throws InputError if it is no such file or names an id twice.
std::vector<RosterEntry> parse_roster(std::string_view csv);

/// The name of an id as plain_line(); empty if the roster has none.
std::string name_in(const std::vector<RosterEntry>& roster, std::string_view id);

}  // namespace raylab
