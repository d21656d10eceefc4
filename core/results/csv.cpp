#include "core/results/csv.hpp"

#include "core/calls/json_value.hpp"
#include "core/results/plain_text.hpp"

#include <algorithm>

namespace raylab {
namespace {

std::string quoted_cell(const std::string& cell) {
  if (cell.find_first_of("\",;\t\r\n") == cell.npos && !cell.starts_with(' ') && !cell.ends_with(' ')) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// What begins a formula, in ASCII or in full width.
bool begins_formula(std::string_view text) {
  for (const std::string_view start : {"=", "+", "-", "@", "＝", "＋", "－", "＠"})
    if (text.starts_with(start)) return true;
  return false;
}

/// Reads cell by cell.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : rest_(text) {}

  bool done() const { return rest_.empty(); }

  std::vector<std::string> line() {
    std::vector<std::string> cells{cell()};
    while (take(",")) cells.push_back(cell());
    if (!take("\r\n") && !take("\n") && !done()) refuse("a quoted cell goes on after its closing quote");
    ++line_;
    return cells;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError("line " + std::to_string(line_) + ": " + what);
  }

  bool take(std::string_view start) {
    if (!rest_.starts_with(start)) return false;
    rest_.remove_prefix(start.size());
    return true;
  }

  std::string cell() {
    if (take("\"")) return quoted();
    const std::size_t end = std::min(rest_.find_first_of(",\n"), rest_.size());
    std::string_view cell = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (cell.ends_with('\r') && (done() || rest_.front() == '\n')) cell.remove_suffix(1);
    if (cell.find('"') != cell.npos) refuse("a quote within a cell that is not quoted");
    return std::string(cell);
  }

  std::string quoted() {
    std::string cell;
    for (;;) {
      const std::size_t quote = rest_.find('"');
      if (quote == rest_.npos) refuse("a quote is not closed");
      cell += rest_.substr(0, quote);
      rest_.remove_prefix(quote + 1);
      if (!take("\"")) break;
      cell += '"';
    }
    line_ += static_cast<int>(std::count(cell.begin(), cell.end(), '\n'));
    return cell;
  }

  std::string_view rest_;
  int line_ = 1;
};

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (&cell == cells.data() ? "" : ",") + quoted_cell(cell);
  return line + "\r\n";
}

std::string csv_text(std::string_view text) {
  const std::string plain = plain_line(text);
  std::string safe;
  bool at_start = true;  // of the cell, or of what another separator would make one
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (at_start && begins_formula(std::string_view(plain).substr(i))) safe += '\'';
    safe += plain[i];
    if (std::string_view(",;|").find(plain[i]) != std::string_view::npos)
      at_start = true;
    else if (std::string_view(" \"").find(plain[i]) == std::string_view::npos)
      at_start = false;
  }
  return safe;
}

std::vector<std::vector<std::string>> parse_csv(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::vector<std::vector<std::string>> lines;
  for (CsvReader reader(text); !reader.done();) {
    std::vector<std::string> line = reader.line();
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace raylab
