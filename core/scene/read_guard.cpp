#include "core/scene/read_guard.hpp"

#include <algorithm>
#include <cstddef>

namespace raylab {
namespace {

constexpr std::size_t npos = std::string_view::npos;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// How many bytes the character at the start of `text` has; 0 if it is not UTF-8. Unicode 15, table 3-7.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continued = [&](std::size_t i) { return byte(i) >= 0x80U && byte(i) <= 0xBFU; };
  const unsigned first = byte(0);
  const unsigned second = byte(1);
  if (first < 0x80U) return 1;
  if (first < 0xC2U || !continued(1)) return 0;
  if (first < 0xE0U) return 2;
  if (first == 0xE0U && second < 0xA0U) return 0;  // could be written shorter
  if (first == 0xEDU && second > 0x9FU) return 0;  // half of a UTF-16 pair
  if (first < 0xF0U) return continued(2) ? 3 : 0;
  if (first == 0xF0U && second < 0x90U) return 0;                     // could be written shorter
  if (first > 0xF4U || (first == 0xF4U && second > 0x8FU)) return 0;  // beyond the last character
  return continued(2) && continued(3) ? 4 : 0;
}

std::size_t find_bad_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text.substr(i));
    if (length == 0) return i;
    i += length;
  }
  return npos;
}

/// The end of the string whose opening quote is at `begin`: just behind its closing quotes. A string on one line also
/// ends with the line: toml++ will refuse it there.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool multi_line = text.substr(begin, 3) == three;
  std::size_t i = begin + (multi_line ? 3 : 1);
  while (i < text.size()) {
    if (text[i] == '\\' && quote == '"') {
      i += 2;
    } else if (multi_line && text.substr(i, 3) == three) {
      const std::size_t after = text.find_first_not_of(quote, i);  // `""""` and `"""""` close such a string too
      return std::min({after, i + 5, text.size()});
    } else if (!multi_line && (text[i] == quote || text[i] == '\n')) {
      return i + 1;
    } else {
      ++i;
    }
  }
  return text.size();
}

std::size_t find_deep_key(std::string_view text) {
  constexpr int most_dots = 8;  // a scene has no key of more than two parts
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.' && ++dots > most_dots) return i;
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') dots = 0;
    ++i;
  }
  return npos;
}

Place place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto characters = std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_begin), before.end(),
                                        [](char c) { return !continues_character(c); });
  return {static_cast<int>(lines) + 1, static_cast<int>(characters) + 1};
}

}  // namespace

std::optional<TextFlaw> find_flaw(std::string_view text) {
  if (text.substr(0, 2) == "\xFE\xFF" || text.substr(0, 2) == "\xFF\xFE") {
    return TextFlaw{{1, 1}, "is UTF-16 text; save the file as UTF-8"};
  }
  if (const std::size_t at = find_bad_utf8(text); at != npos) {
    return TextFlaw{place_of(text, at), "is not UTF-8 text from here on; save the file as UTF-8"};
  }
  if (const std::size_t at = find_deep_key(text); at != npos) {
    return TextFlaw{place_of(text, at), "has more dots than any key of a scene; remove some, or put quotes around a text"};
  }
  return std::nullopt;
}

}  // namespace raylab
