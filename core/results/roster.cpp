#include "core/results/roster.hpp"

#include "core/calls/json_value.hpp"
#include "core/results/csv.hpp"
#include "core/results/plain_text.hpp"
#include "core/scene/diagnostic.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

namespace raylab {
namespace {

std::string escaped_byte(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', digits[byte >> 4U], digits[byte & 15U]};
}

/// A text that unescaped() gives back, and that csv_text() has nothing to change in: what it would change is escaped, from
/// the left, a byte at a time.
std::string escaped(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += c == '\\' ? escaped_byte(c) : std::string(1, c);
  for (std::string safe = csv_text(text); safe != text; safe = csv_text(text)) {
    const auto changed = std::mismatch(text.begin(), text.end(), safe.begin(), safe.end()).first;
    const auto at = static_cast<std::size_t>(changed - text.begin());
    text.replace(at, 1, escaped_byte(text[at]));
  }
  return text;
}

/// The byte that \xHH at the start of `text` stands for.
std::optional<char> byte_at(std::string_view text) {
  unsigned byte = 0;
  if (text.size() < 4 || !text.starts_with("\\x")) return {};
  const auto [end, error] = std::from_chars(text.data() + 2, text.data() + 4, byte, 16);
  if (error != std::errc() || end != text.data() + 4) return {};
  return static_cast<char>(static_cast<unsigned char>(byte));
}

std::string unescaped(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const std::optional<char> byte = byte_at(text);
    name += byte.value_or(text.front());
    text.remove_prefix(byte ? 4 : 1);
  }
  return name;
}

}  // namespace

std::string roster_csv(const std::vector<RosterEntry>& roster) {
  std::string csv = csv_line({"id", "name"});
  for (const RosterEntry& entry : roster) csv += csv_line({escaped(entry.id), escaped(entry.name)});
  return csv;
}

std::vector<RosterEntry> parse_roster(std::string_view csv) {
  const std::vector<std::vector<std::string>> lines = parse_csv(csv);
  if (lines.empty() || lines.front() != std::vector<std::string>{"id", "name"}) throw InputError("line 1: wanted id,name");
  std::vector<RosterEntry> roster;
  std::set<std::string> ids;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != 2)
      throw InputError("entry " + std::to_string(i) + ": wanted an id and a name, got " + std::to_string(lines[i].size()) +
                       " cells");
    roster.push_back({unescaped(lines[i][0]), unescaped(lines[i][1])});
    if (!ids.insert(roster.back().id).second)
      throw InputError("entry " + std::to_string(i) + ": the id " + quoted(roster.back().id) + " is there twice");
  }
  return roster;
}

std::string name_in(const std::vector<RosterEntry>& roster, std::string_view id) {
  const auto found = std::find_if(roster.begin(), roster.end(), [&](const RosterEntry& entry) { return entry.id == id; });
  return found == roster.end() ? "" : plain_line(found->name);
}

}  // namespace raylab
