#include "core/scene/read_toml.hpp"

#include "core/scene/read_guard.hpp"
#include "core/scene/utf8.hpp"

#if __has_include(<toml++/toml.hpp>)
#include <toml++/toml.hpp>
#else
#include <toml++/toml.h>
#endif

#include <algorithm>
#include <array>
#include <utility>

namespace raylab {

const TomlEntry* find(const TomlTable& table, std::string_view key) {
  const auto entry = std::lower_bound(table.entries.begin(), table.entries.end(), key,
                                      [](const TomlEntry& e, std::string_view wanted) { return e.key < wanted; });
  return entry != table.entries.end() && entry->key == key ? &*entry : nullptr;
}

namespace {

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

TomlValue convert(const toml::node& node);

TomlList convert(const toml::array& array) {
  TomlList list;
  list.reserve(array.size());
  for (const toml::node& element : array) list.push_back(convert(element));
  return list;
}

TomlTable convert(const toml::table& table) {
  TomlTable result;
  result.entries.reserve(table.size());
  for (const auto& [key, node] : table) {
    result.entries.push_back({std::string(key.str()), place_of(key.source()), convert(node)});
  }
  return result;
}

TomlValue convert(const toml::node& node) {
  const Place place = place_of(node.source());
  if (const auto* text = node.as_string()) return {place, text->get()};
  if (const auto* whole = node.as_integer()) return {place, whole->get()};
  if (const auto* number = node.as_floating_point()) return {place, number->get()};
  if (const auto* flag = node.as_boolean()) return {place, flag->get()};
  if (const auto* array = node.as_array()) return {place, convert(*array)};
  if (const auto* table = node.as_table()) return {place, convert(*table)};
  return {place, TomlDate{}};
}

/// What to do about an error, found by a part of toml++'s words for it.
struct Hint {
  std::string_view part;
  std::string_view advice;
  bool about_number = false;  ///< toml++ then gives the place where it stopped reading the number
};

constexpr std::array hints{
    Hint{"could not be interpreted as a value", "the largest number is 1.797e308", true},
    Hint{"not representable in 64 bits", "write so large a number with an exponent, as in 1e20, up to 1.797e308", true},
    Hint{"exceeds length limit", "17 digits are enough for any number", true},
    Hint{"too long to identify", "17 digits are enough for any number", true},
    Hint{"table header: cannot redefine existing array", "write [[double brackets]] each time"},
    Hint{"cannot redefine existing", "write it once"},
    Hint{"could not determine value type", "a text needs quotes"},
    Hint{"expected 'true'", "write true; a text needs quotes"},
    Hint{"expected 'false'", "write false; a text needs quotes"},
    Hint{"expected 'nan'", "a text needs quotes"},
    Hint{"expected 'inf'", "write inf; a text needs quotes"},
};

const Hint* hint_for(std::string_view description) {
  const auto found = std::find_if(hints.begin(), hints.end(),
                                  [&](const Hint& hint) { return description.find(hint.part) != std::string_view::npos; });
  return found != hints.end() ? &*found : nullptr;
}

/// toml++'s "Error while parsing string: encountered end-of-file" as "not valid TOML (string): encountered end-of-file".
std::string readable(std::string_view description) {
  constexpr std::string_view prefix = "Error while parsing ";
  const Hint* hint = hint_for(description);
  std::string result = "not valid TOML: ";
  if (description.substr(0, prefix.size()) == prefix) {
    const std::size_t colon = std::min(description.find(": "), description.size() - 2);
    result = "not valid TOML (" + std::string(description.substr(prefix.size(), colon - prefix.size())) + "): ";
    description.remove_prefix(colon + 2);
  }
  result += printable(description);
  return hint != nullptr ? result + "; " + std::string(hint->advice) : result;
}

/// Where the number begins that ends at, or reaches over, `place`.
Place start_of_number(std::string_view text, Place place) {
  for (int line = 1; line < place.line; ++line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  std::size_t offset = 0;
  for (int column = 1; column < place.column && offset < text.size(); ++column)
    offset += std::max<std::size_t>(1, utf8_length(text.substr(offset)));
  const std::size_t before = text.substr(0, offset).find_last_of(" \t\r\n=,[{");
  const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
  return {place.line, place.column - static_cast<int>(offset - start)};
}

}  // namespace

std::optional<TomlTable> parse_toml(std::string_view text, Report& report) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  if (const std::optional<TextFlaw> flaw = find_flaw(text)) {
    report.error(flaw->place, {}, flaw->text);
    return std::nullopt;
  }
  try {
    return convert(toml::parse(text));
  } catch (const toml::parse_error& error) {
    const Hint* hint = hint_for(error.description());
    const Place place = place_of(error.source());
    report.error(hint != nullptr && hint->about_number ? start_of_number(text, place) : place, {},
                 readable(error.description()));
    return std::nullopt;
  }
}

}  // namespace raylab
