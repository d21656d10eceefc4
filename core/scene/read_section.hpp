#pragma once

#include "core/math/vec3.hpp"
#include "core/scene/diagnostic.hpp"
#include "core/scene/read_rules.hpp"
#include "core/scene/read_toml.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

enum class Need { required, optional };

/// One table of a scene file, read field by field into plain structs. Each reading function returns whether it set the
/// value: a field that is absent keeps the one it had, and one that is wrong is reported, so that reading goes on to the
/// next mistake. The section remembers the keys that it was asked for: they are the known ones.
class Section {
 public:
  /// `name` is the table's key, "sphere[0]", or empty for the whole file; `place` is its header's.
  Section(const TomlTable& table, std::string name, Place place, Report& report);

  bool number(std::string_view key, Need need, double& value, Rules rules);
  bool whole(std::string_view key, Need need, int& value, int least, int most);
  bool flag(std::string_view key, Need need, bool& value);
  /// A text on one line.
  bool text(std::string_view key, Need need, std::string& value);
  /// A list of texts, each on one line.
  bool texts(std::string_view key, Need need, std::vector<std::string>& values);
  /// A list of three numbers, each of which keeps `rules`.
  bool vector(std::string_view key, Need need, Vec3& value, Rules rules);
  /// A vector of any length but zero.
  bool direction(std::string_view key, Need need, Vec3& value);

  /// The table [key]; nothing if it is missing or no table.
  std::optional<Section> table(std::string_view key);
  /// The tables [[key]], in file order.
  std::vector<Section> tables(std::string_view key);

  /// To be called last: reports the keys that nobody asked for.
  void finish() const;

  bool has(std::string_view key) const { return find(*table_, key) != nullptr; }
  void error(std::string_view key, std::string text) const;
  void warning(std::string_view key, std::string text) const;

  /// Where the value of `key` stands; where it is missing, the section's header.
  Place place(std::string_view key) const;
  Place place() const { return place_; }
  const std::string& name() const { return name_; }

 private:
  const TomlValue* find_value(std::string_view key, Need need, std::string_view wanted);
  bool set_number(const TomlValue& found, const std::string& path, double& value, Rules rules) const;
  bool wrong(std::string_view key, std::string text) const;  ///< reports an error and returns false
  std::string path(std::string_view key) const;

  const TomlTable* table_;
  std::string name_;
  Place place_;
  Report* report_;
  std::vector<std::string_view> known_;
};

}  // namespace raylab
