#include "core/calls/plain_json.hpp"

#include "core/scene/diagnostic.hpp"
#include "core/scene/nearest_name.hpp"

#include <cmath>

namespace raylab {
namespace {

/// A value in a few words, for messages.
struct Kind {
  std::string operator()(std::nullptr_t) const { return "null"; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return to_text(value); }
  std::string operator()(const std::string& value) const { return "the string " + quoted(value); }
  std::string operator()(const JsonList&) const { return "a list"; }
  std::string operator()(const JsonObject&) const { return "an object"; }
};

[[noreturn]] void refuse_kind(const JsonValue& json, const std::string& wanted, const JsonPlace& place) {
  place.refuse("wanted " + wanted + ", got " + std::visit(Kind{}, json.data));
}

/// "one, two LAST three".
std::string listed(std::span<const std::string_view> words, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : last;
    text += words[i];
  }
  return text;
}

std::string help_with(std::string_view key, std::span<const std::string_view> keys) {
  if (keys.empty()) return "; none are known here";
  const std::string_view nearest = nearest_name(key, keys);
  return nearest.empty() ? "; known keys: " + listed(keys, ", ") : ", did you mean " + quoted(nearest) + "?";
}

}  // namespace

void JsonPlace::refuse(const std::string& what) const { throw InputError(outer_ ? text() + ": " + what : what); }

std::string JsonPlace::text() const {
  const std::string before = outer_ && outer_->outer_ ? outer_->text() : "";
  if (index_) return before + '[' + std::to_string(*index_) + ']';
  return before + (before.empty() ? "" : ".") + shortened(key_);
}

double read_number(const JsonValue& json, const JsonPlace& place) {
  if (const auto* number = std::get_if<double>(&json.data)) return *number;
  const auto* text = std::get_if<std::string>(&json.data);
  if (!text) refuse_kind(json, "a number", place);
  try {
    return parse_number(*text);
  } catch (const InputError& error) {
    place.refuse(error.what());
  }
}

double read_whole(const JsonValue& json, double least, double most, const JsonPlace& place) {
  const double number = read_number(json, place);
  if (number >= least && number <= most && number == std::trunc(number)) return number;
  place.refuse("wanted a whole number from " + to_text(least) + " to " + to_text(most) + ", got " + to_text(number));
}

const std::string& read_word(const JsonValue& json, std::span<const std::string_view> words, const JsonPlace& place) {
  const auto* text = std::get_if<std::string>(&json.data);
  if (!text || std::find(words.begin(), words.end(), *text) == words.end()) refuse_kind(json, alternatives(words), place);
  return *text;
}

const JsonList& read_list(const JsonValue& json, const JsonPlace& place) {
  const auto* list = std::get_if<JsonList>(&json.data);
  if (!list) refuse_kind(json, "a list", place);
  return *list;
}

const JsonObject& read_object(const JsonValue& json, std::span<const std::string_view> keys, const JsonPlace& place) {
  const auto* object = std::get_if<JsonObject>(&json.data);
  if (!object) refuse_kind(json, "an object", place);
  std::vector<std::string_view> seen;
  for (const auto& [key, value] : *object) {
    const JsonPlace here(place, key);
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) here.refuse("unknown key" + help_with(key, keys));
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) here.refuse("is there twice");
    seen.push_back(key);
  }
  return *object;
}

const JsonValue* find_field(const JsonObject& object, const Field& field, const JsonPlace& place) {
  const std::string_view name = field.name;
  const auto found =
      std::find_if(object.begin(), object.end(), [&](const JsonMember& member) { return member.key == name; });
  if (found != object.end()) return &found->value;
  if (!field.optional) JsonPlace(place, name).refuse("is missing");
  return nullptr;
}

std::string alternatives(std::span<const std::string_view> words) { return listed(words, " or "); }

void PlainJson<bool>::read(const JsonValue& json, bool& value, const JsonPlace& place) {
  const auto* flag = std::get_if<bool>(&json.data);
  if (!flag) refuse_kind(json, describe(), place);
  value = *flag;
}

void PlainJson<std::string>::read(const JsonValue& json, std::string& value, const JsonPlace& place) {
  const auto* text = std::get_if<std::string>(&json.data);
  if (!text) refuse_kind(json, "a string", place);
  value = *text;
}

void PlainJson<Vec3>::read(const JsonValue& json, Vec3& value, const JsonPlace& place) {
  const auto* list = std::get_if<JsonList>(&json.data);
  if (!list) refuse_kind(json, "a list of 3 numbers", place);
  if (list->size() != 3) place.refuse("wanted a list of 3 numbers, got " + std::to_string(list->size()));
  for (std::size_t i = 0; i < 3; ++i)
    value[static_cast<Vec3::length_type>(i)] = read_number((*list)[i], JsonPlace(place, i));
}

void PlainJson<Vec3>::write(std::string& out, const Vec3& value, NumberWriter number) {
  out += '[' + number(value.x) + ',' + number(value.y) + ',' + number(value.z) + ']';
}

}  // namespace raylab
