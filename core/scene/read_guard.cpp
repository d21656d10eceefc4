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

/// The first letter beyond ASCII behind a backslash, or behind a backslash and the spaces and line ends that it removes.
std::size_t find_odd_escape(std::string_view text, std::size_t begin) {
  for (std::size_t i = text.find('\\', begin); i < text.size(); i = text.find('\\', i + 2)) {
    const std::size_t next = text.find_first_not_of(" \t\r\n", i + 1);
    if (next != npos && !is_plain(text[next])) return next;
  }
  return npos;
}

struct Flaw {
  std::size_t offset;
  const char* text;
};

/// toml++ looks ahead from the first sign or digit of a number to the next space, comma or bracket that closes, through
/// quotes too: in x=6"text" it meets the text's letters, and does not survive all of them.
std::size_t find_text_in_number(std::string_view text, std::size_t begin) {
  constexpr std::size_t look_ahead = 128;
  const std::string_view ahead = text.substr(0, begin + look_ahead);
  return find_not_plain(ahead.substr(0, ahead.find_first_of(" \t\n\r,]}#", begin)), begin);
}

/// Does a value or a key begin at `i`?
bool begins(std::string_view text, std::size_t i) {
  return i == 0 || std::string_view(" \t\n\r=,[{").find(text[i - 1]) != npos;
}

bool may_begin_number(char c) { return (c >= '0' && c <= '9') || c == '+' || c == '-'; }

std::optional<Flaw> find_flaw_of_syntax(std::string_view text) {
  constexpr int most_dots = 8;  // a scene has no key of more than two parts
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_string(text, i);
      const std::size_t odd = c == '"' ? find_odd_escape(text.substr(0, end), i) : npos;
      if (odd != npos) return Flaw{odd, "a backslash may not stand before this character"};
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (!is_plain(c)) return Flaw{i, "a character that may stand in quotes or behind a # only"};
    if (may_begin_number(c) && begins(text, i)) {
      const std::size_t odd = find_text_in_number(text, i);
      if (odd != npos) return Flaw{odd, "a space or a comma is missing before this text"};
    }
    if (c == '.' && ++dots > most_dots) return Flaw{i, "more dots than any key of a scene has; a text needs quotes"};
    if (std::string_view("\n,=[{").find(c) != npos) dots = 0;
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
  if (const std::optional<Flaw> flaw = find_flaw_of_syntax(text)) return TextFlaw{place_of(text, flaw->offset), flaw->text};
  return std::nullopt;
}

}  // namespace raylab
