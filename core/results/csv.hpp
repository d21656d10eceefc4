#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// A line of CSV (RFC 4180), ended by \r\n. Cells are quoted where that is needed.
std::string csv_line(const std::vector<std::string>& cells);

/// Any text as text of a cell: plain_line(), in which no spreadsheet sees a formula, whichever separator it reads by: an
/// apostrophe stands before = + - and @ where a cell begins or could begin.
std::string csv_text(std::string_view text);

/// The cells of all lines of a CSV file; a byte order mark is skipped.
/// Throws InputError, with the line, for quotes that stand where RFC 4180 has none or are not closed.
std::vector<std::vector<std::string>> parse_csv(std::string_view text);

}  // namespace raylab
