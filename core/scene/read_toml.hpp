#pragma once

#include "core/scene/diagnostic.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raylab {

struct TomlValue;
struct TomlEntry;

using TomlList = std::vector<TomlValue>;

/// The entries of a table, sorted by key.
struct TomlTable {
  std::vector<TomlEntry> entries;
};

/// A date, a time or both. No scene has one, so only the fact is kept.
struct TomlDate {};

/// A value and where it stands: for a table that is its [header].
struct TomlValue {
  Place place;
  std::variant<std::string, std::int64_t, double, bool, TomlDate, TomlList, TomlTable> data;
};

struct TomlEntry {
  std::string key;
  Place key_place;
  TomlValue value;
};

/// The entry of that key, or null.
const TomlEntry* find(const TomlTable& table, std::string_view key);

/// Reads TOML 1.0. On a syntax error: nothing, and the error in `report`. Survives any bytes.
std::optional<TomlTable> parse_toml(std::string_view text, Report& report);

}  // namespace raylab
