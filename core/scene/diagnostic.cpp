#include "core/scene/diagnostic.hpp"

#include "core/scene/utf8.hpp"

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

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0 || is_control(text[i])) {
      result += escaped(text[i++]);
    } else {
      result += text.substr(i, length);
      i += length;
    }
  }
  return result;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) return printable(text);
  std::size_t end = longest;
  while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U && end > 0) --end;  // not within a character
  return printable(text.substr(0, end)) + "...";
}

std::string quoted(std::string_view text) { return "'" + shortened(text) + "'"; }

std::string to_text(double number) {
  if (std::isnan(number)) return "nan";  // to_chars would show a sign that means nothing
  std::array<char, 32> buffer{};
  std::string text(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr);
  if (const std::size_t plus = text.find('+'); plus != std::string::npos) text.erase(plus, 1);  // 1e100, as people write it
  return text;
}

}  // namespace raylab
