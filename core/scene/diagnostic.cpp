#include "core/scene/diagnostic.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tuple>
#include <utility>

namespace raylab {

std::string to_string(const Diagnostic& diagnostic) {
  std::string line = diagnostic.file;
  if (diagnostic.line > 0) line += ":" + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column);
  line += ": ";
  if (diagnostic.severity == Diagnostic::Severity::warning) line += "warning: ";
  if (!diagnostic.key.empty()) line += diagnostic.key + ": ";
  return line + diagnostic.text;
}

void Report::error(Place place, std::string key, std::string text) {
  diagnostics_.push_back({Diagnostic::Severity::error, file_, place.line, place.column, std::move(key), std::move(text)});
}

void Report::warning(Place place, std::string key, std::string text) {
  diagnostics_.push_back({Diagnostic::Severity::warning, file_, place.line, place.column, std::move(key), std::move(text)});
}

bool Report::has_error() const {
  return std::any_of(diagnostics_.begin(), diagnostics_.end(),
                     [](const Diagnostic& d) { return d.severity == Diagnostic::Severity::error; });
}

std::vector<Diagnostic> Report::sorted() const {
  std::vector<Diagnostic> result = diagnostics_;
  std::stable_sort(result.begin(), result.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  return result;
}

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

std::string escaped(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
}

}  // namespace

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += is_control(c) ? escaped(c) : std::string(1, c);
  return result + (text.size() > longest ? "...'" : "'");
}

std::string to_text(double number) {
  if (std::isnan(number)) return "nan";  // to_chars would show a sign that means nothing
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string();
}

}  // namespace raylab
