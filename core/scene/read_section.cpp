#include "core/scene/read_section.hpp"

#include "core/scene/nearest_name.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

namespace raylab {
namespace {

/// What was found, for a sentence that ends in "got ...".
struct Found {
  std::string operator()(const std::string&) const { return "a string"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const {
    std::string text = to_text(value);
    const bool looks_whole = text.find_first_not_of("-0123456789") == std::string::npos;
    return looks_whole ? text + ".0" : text;  // as the file has it, or "must be a whole number, got 640" would puzzle
  }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(const TomlDate&) const { return "a date or time"; }
  std::string operator()(const TomlList& list) const { return "a list of " + std::to_string(list.size()); }
  std::string operator()(const TomlTable&) const { return "a table"; }
};

std::string got(const TomlValue& value) { return ", got " + std::visit(Found{}, value.data); }

std::string indexed(std::string_view key, std::size_t index) { return std::string(key) + "[" + std::to_string(index) + "]"; }

bool is_one_line(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; });
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

}  // namespace

Section::Section(const TomlTable& table, std::string name, Place place, Report& report)
    : table_(&table), name_(std::move(name)), place_(place), report_(&report) {}

bool Section::number(std::string_view key, Need need, double& value, Rules rules) {
  const TomlValue* found = find_value(key, need, "a number");
  return found != nullptr && set_number(*found, path(key), value, rules);
}

bool Section::whole(std::string_view key, Need need, int& value, int least, int most) {
  const TomlValue* found = find_value(key, need, "a whole number");
  if (found == nullptr) return false;
  const auto* number = std::get_if<std::int64_t>(&found->data);
  if (number == nullptr) return wrong(key, "must be a whole number" + got(*found));
  if (*number < least || *number > most) {
    return wrong(key, "must be between " + std::to_string(least) + " and " + std::to_string(most) + got(*found));
  }
  value = static_cast<int>(*number);
  return true;
}

bool Section::flag(std::string_view key, Need need, bool& value) {
  const TomlValue* found = find_value(key, need, "true or false");
  if (found == nullptr) return false;
  const auto* flag = std::get_if<bool>(&found->data);
  if (flag == nullptr) return wrong(key, "must be true or false" + got(*found));
  value = *flag;
  return true;
}

bool Section::text(std::string_view key, Need need, std::string& value) {
  const TomlValue* found = find_value(key, need, "a string");
  if (found == nullptr) return false;
  const auto* text = std::get_if<std::string>(&found->data);
  if (text == nullptr) return wrong(key, "must be a string" + got(*found));
  if (!is_one_line(*text)) return wrong(key, "must be one line without control characters, got " + quoted(*text));
  value = *text;
  return true;
}

bool Section::texts(std::string_view key, Need need, std::vector<std::string>& values) {
  const TomlValue* found = find_value(key, need, "a list of strings");
  if (found == nullptr) return false;
  const auto* list = std::get_if<TomlList>(&found->data);
  if (list == nullptr) return wrong(key, "must be a list of strings" + got(*found));
  std::vector<std::string> all;
  for (const TomlValue& value : *list) {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr || !is_one_line(*text)) return wrong(key, "must be a list of strings, each on one line");
    all.push_back(*text);
  }
  values = std::move(all);
  return true;
}

bool Section::vector(std::string_view key, Need need, Vec3& value, Rules rules) {
  const TomlValue* found = find_value(key, need, "a list of 3 numbers");
  if (found == nullptr) return false;
  const auto* list = std::get_if<TomlList>(&found->data);
  if (list == nullptr || list->size() != 3) return wrong(key, "must be a list of 3 numbers" + got(*found));
  const bool x = set_number((*list)[0], path(indexed(key, 0)), value.x, rules);
  const bool y = set_number((*list)[1], path(indexed(key, 1)), value.y, rules);
  const bool z = set_number((*list)[2], path(indexed(key, 2)), value.z, rules);
  return x && y && z;
}

bool Section::direction(std::string_view key, Need need, Vec3& value) {
  if (!vector(key, need, value, direction_rules)) return false;
  return value != Vec3(0) || wrong(key, "must not be [0, 0, 0]: a direction has a length");
}

std::optional<Section> Section::table(std::string_view key) {
  known_.push_back(key);
  const TomlEntry* entry = find(*table_, key);
  if (entry == nullptr) return std::nullopt;
  const std::string wanted = "must be one table, written [" + path(key) + "]";
  if (const auto* table = std::get_if<TomlTable>(&entry->value.data)) {
    return Section(*table, path(key), entry->value.place, *report_);
  }
  error(key, wanted + got(entry->value));
  return std::nullopt;
}

std::vector<Section> Section::tables(std::string_view key) {
  known_.push_back(key);
  const TomlEntry* entry = find(*table_, key);
  if (entry == nullptr) return {};
  const auto* list = std::get_if<TomlList>(&entry->value.data);
  if (list == nullptr) {
    error(key, "must be a list of tables, each written [[" + path(key) + "]]" + got(entry->value));
    return {};
  }
  std::vector<Section> sections;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const TomlValue& value = (*list)[i];
    const std::string name = path(indexed(key, i));
    if (const auto* table = std::get_if<TomlTable>(&value.data)) {
      sections.emplace_back(*table, name, value.place, *report_);
    } else {
      report_->error(value.place, name, "must be a table, written [[" + path(key) + "]]" + got(value));
    }
  }
  return sections;
}

void Section::finish() const {
  for (const TomlEntry& entry : table_->entries) {
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    const std::string_view nearest = nearest_name(entry.key, known_);
    const std::string help = nearest.empty() ? "; known keys: " + listed(known_) : ", did you mean " + quoted(nearest) + "?";
    report_->error(entry.key_place, path(shortened(entry.key)), "unknown key" + help);
  }
}

void Section::error(std::string_view key, std::string text) const { report_->error(place(key), path(key), std::move(text)); }

void Section::warning(std::string_view key, std::string text) const {
  report_->warning(place(key), path(key), std::move(text));
}

Place Section::place(std::string_view key) const {
  const TomlEntry* entry = find(*table_, key);
  return entry != nullptr ? entry->value.place : place_;
}

const TomlValue* Section::find_value(std::string_view key, Need need, std::string_view wanted) {
  known_.push_back(key);
  const TomlEntry* entry = find(*table_, key);
  if (entry != nullptr) return &entry->value;
  if (need == Need::required) error(key, "missing, must be " + std::string(wanted));
  return nullptr;
}

bool Section::set_number(const TomlValue& found, const std::string& path, double& value, Rules rules) const {
  const auto* whole = std::get_if<std::int64_t>(&found.data);
  const auto* real = std::get_if<double>(&found.data);
  if (whole == nullptr && real == nullptr) {
    report_->error(found.place, path, "must be a number" + got(found));
    return false;
  }
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  if (const char* wanted = first_broken(rules, number)) {
    report_->error(found.place, path, wanted + got(found));
    return false;
  }
  value = number;
  return true;
}

bool Section::wrong(std::string_view key, std::string text) const {
  error(key, std::move(text));
  return false;
}

std::string Section::path(std::string_view key) const { return name_ + (name_.empty() ? "" : ".") + std::string(key); }

}  // namespace raylab
