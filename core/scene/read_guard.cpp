#include "core/scene/read_guard.hpp"

#include "core/scene/utf8.hpp"

#include <algorithm>
#include <cstddef>

namespace raylab {
namespace {

constexpr std::size_t npos = std::string_view::npos;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

std::size_t find_bad_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
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

bool is_plain(char c) { return (c >= ' ' && c <= '~') || c == '\t' || c == '\n' || c == '\r'; }

std::size_t find_not_plain(std::string_view text, std::size_t begin) {
  while (begin < text.size() && is_plain(text[begin])) ++begin;
  return begin < text.size() ? begin : npos;
}

struct Flaw {
  std::size_t offset;
  const char* text;
};

/// Looks at what is neither string nor comment.
std::optional<Flaw> find_flaw_outside_strings(std::string_view text) {
  constexpr int most_dots = 8;  // a scene has no key of more than two parts
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_string(text, i);
      // toml++ takes a string that touches what stands before it, as in 0"text", for a part of that.
      const bool touches = i > 0 && std::string_view(" \t\n\r=,[{").find(text[i - 1]) == npos;
      const std::size_t odd = touches ? find_not_plain(text.substr(0, end), i) : npos;
      if (odd != npos) return Flaw{odd, "a space or a comma is missing before this text"};
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (!is_plain(c)) return Flaw{i, "a character that may stand in quotes or behind a # only"};
    if (c == '.' && ++dots > most_dots) return Flaw{i, "more dots than any key of a scene has; a text needs quotes"};
    if (c == '\n' || c == ',' || c == '=' || c == '[' || c == '{') dots = 0;
    ++i;
  }
  return std::nullopt;
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
    return TextFlaw{{1, 1}, "UTF-16 text; save the file as UTF-8"};
  }
  if (const std::size_t at = find_bad_utf8(text); at != npos) {
    return TextFlaw{place_of(text, at), "not UTF-8 text from here on; save the file as UTF-8"};
  }
  if (const std::optional<Flaw> flaw = find_flaw_outside_strings(text))
    return TextFlaw{place_of(text, flaw->offset), flaw->text};
  return std::nullopt;
}

}  // namespace raylab
