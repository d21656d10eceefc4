#include "core/scene/read_cloud.hpp"

#include "core/scene/read_decimal.hpp"
#include "core/scene/read_rules.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <system_error>
#include <utility>

namespace raylab {
namespace {

struct Column {
  const char* name;
  Rules rules;
};

constexpr std::array columns{Column{"x", coordinate_rules},  Column{"y", coordinate_rules}, Column{"z", coordinate_rules},
                             Column{"radius", radius_rules}, Column{"r", color_rules},      Column{"g", color_rules},
                             Column{"b", color_rules}};
constexpr std::string_view short_header = "x,y,z,radius";
constexpr std::string_view long_header = "x,y,z,radius,r,g,b";
constexpr std::size_t short_width = 4;

/// Hands out the lines of a text, without their ends.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  bool empty() const { return rest_.empty(); }
  int number() const { return number_; }  ///< of the line that next() gave

  std::string_view next() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// One field of a row, without its comma.
struct Field {
  std::string_view text;
  std::optional<double> value;  ///< empty if it is no number
};

Field first_field(std::string_view row) {
  // Nearly every field is plain, so the number is read first, and its end found by that: a third of the time saved.
  double value = 0;
  const char* const row_end = row.data() + row.size();
  const auto [end, error] = std::from_chars(row.data(), row_end, value);
  if (error == std::errc{} && (end == row_end || *end == ',')) {
    return {row.substr(0, static_cast<std::size_t>(end - row.data())), value};
  }
  const std::string_view text = row.substr(0, row.find(','));
  return {text, parse_decimal(text)};
}

class CloudReader {
 public:
  CloudReader(const std::string& key, Report& report) : key_(key), report_(report) {}

  CloudTable read(std::string_view text) {
    // Empty lines at the end are harmless; every other one is a row that was lost.
    Lines lines(text.substr(0, text.find_last_not_of("\r\n") + 1));
    if (!read_header(lines.next())) return {};
    if (lines.empty()) error(2, 1, "no rows: at least one sphere must follow the header");
    while (!lines.empty() && !too_many_mistakes(lines.number())) {
      const std::string_view line = lines.next();
      read_row(line, lines.number());
    }
    return std::move(table_);
  }

 private:
  bool read_header(std::string_view line) {
    if (line == short_header || line == long_header) {
      table_.has_colors = line == long_header;
      width_ = line == long_header ? columns.size() : short_width;
      return true;
    }
    std::string text = "the header must be x,y,z,radius or x,y,z,radius,r,g,b, got " + quoted(line);
    if (line.substr(0, 3) == "\xEF\xBB\xBF") text = "begins with a byte order mark; save the file as UTF-8 without one";
    error(1, 1, text);
    return false;
  }

  void read_row(std::string_view line, int number) {
    if (line.empty()) return error(number, 1, "an empty line between rows; remove it");
    std::array<double, columns.size()> values{};
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= line.size(); ++count) {
      const Field field = first_field(line.substr(begin));
      if (count < width_) values[count] = checked(columns[count], field, number, begin);
      begin += field.text.size() + 1;
    }
    if (count != width_) {
      return error(number, 1, "must be " + std::to_string(width_) + " numbers, got " + std::to_string(count));
    }
    table_.spheres.push_back({{values[0], values[1], values[2]}, values[3]});
    if (*table_.has_colors) table_.colors.push_back({values[4], values[5], values[6]});
  }

  double checked(const Column& column, const Field& field, int number, std::size_t offset) {
    const char* wanted = field.value ? first_broken(column.rules, *field.value) : "must be a number";
    if (wanted == nullptr) return *field.value;
    const std::string got = field.value ? std::string(field.text.substr(0, 40)) : quoted(field.text);
    error(number, static_cast<int>(offset) + 1, std::string(wanted) + ", got " + got, column.name);
    return 0;
  }

  /// A table that is wrong throughout, its columns swapped say, would fill the memory with reports.
  bool too_many_mistakes(int line) {
    constexpr int most = 100'000;
    if (mistakes_ < most) return false;
    error(line + 1, 1, "not read from here on: " + std::to_string(mistakes_) + " mistakes before");
    return true;
  }

  void error(int line, int column, std::string text, const std::string& field = {}) {
    ++mistakes_;
    report_.error({line, column}, field.empty() ? key_ : key_ + "." + field, std::move(text));
  }

  const std::string& key_;
  Report& report_;
  std::size_t width_ = 0;
  int mistakes_ = 0;
  CloudTable table_;
};

}  // namespace

CloudTable parse_cloud(std::string_view text, const std::string& key, Report& report) {
  return CloudReader(key, report).read(text);
}

}  // namespace raylab
