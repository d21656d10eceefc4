#include "core/results/plain_text.hpp"

#include "core/scene/diagnostic.hpp"
#include "core/scene/utf8.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace raylab {
namespace {

/// The number of the one character in `utf8`.
std::uint32_t code_point(std::string_view utf8) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(utf8[i])); };
  if (utf8.size() == 1) return byte(0);
  std::uint32_t code = byte(0) & (0x7fU >> utf8.size());
  for (std::size_t i = 1; i < utf8.size(); ++i) code = (code << 6U) | (byte(i) & 0x3fU);
  return code;
}

struct Range {
  std::uint32_t first, last;
};

/// Control characters beyond ASCII, marks of direction, ends of lines, the byte order mark, and what XML does not take.
constexpr std::array<Range, 7> not_plain{{{0x80, 0x9f},
                                          {0x61c, 0x61c},
                                          {0x200e, 0x200f},
                                          {0x2028, 0x202e},
                                          {0x2066, 0x2069},
                                          {0xfeff, 0xfeff},
                                          {0xfffe, 0xffff}}};

bool is_plain(std::uint32_t code) {
  return std::none_of(not_plain.begin(), not_plain.end(),
                      [&](const Range& range) { return code >= range.first && code <= range.last; });
}

std::string escaped(std::uint32_t code) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "\\u%04x", static_cast<unsigned>(code));
  return text.data();
}

std::string plain_character(std::string_view utf8) {
  const std::uint32_t code = code_point(utf8);
  return is_plain(code) ? std::string(utf8) : escaped(code);
}

}  // namespace

std::string plain_line(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    const std::string_view character = text.substr(0, length);
    plain += length == 1 ? printable(character) : plain_character(character);
    text.remove_prefix(length);
  }
  return plain;
}

std::string plain_text(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    const bool carriage = end > 0 && end < text.size() && text[end] == '\n' && text[end - 1] == '\r';
    plain += plain_line(text.substr(0, carriage ? end - 1 : end));
    if (end == text.size()) break;
    plain += text[end];
    text.remove_prefix(end + 1);
  }
  return plain;
}

}  // namespace raylab
