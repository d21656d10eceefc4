#pragma once

#include "core/calls/json_value.hpp"
#include "core/math/fields.hpp"
#include "core/math/vec3.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace raylab {

/// Where a value stands in an input, for messages: "candidates[3].t". It refers to the place around it, which must outlive
/// it.
class JsonPlace {
 public:
  JsonPlace() = default;  ///< the whole input
  JsonPlace(const JsonPlace& outer, std::string_view key) : outer_(&outer), key_(key) {}
  JsonPlace(const JsonPlace& outer, std::size_t index) : outer_(&outer), index_(index) {}

  /// Throws InputError: the place and what is wrong there.
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  std::string text() const;

  const JsonPlace* outer_ = nullptr;
  std::string_view key_;
  std::optional<std::size_t> index_;
};

/// How floating-point numbers are written: `json_number` or `json_hex_number`.
using NumberWriter = std::string (*)(double);

/// JSON of the plain data T that a task takes or returns, both ways. One for each kind of type stands below: numbers,
/// booleans, vectors and colors, enums with RAYLAB_NAMES, structs with RAYLAB_FIELDS, lists and optional values. Each has
///
///     static void read(const JsonValue& json, T& value, const JsonPlace& place);  // throws InputError
///     static void write(std::string& out, const T& value, NumberWriter number);   // appends
///     static std::string describe();                                              // "{center: [x, y, z], radius: number}"
template <class T>
struct PlainJson {
  static_assert(sizeof(T) == 0, "no plain data: has the struct its RAYLAB_FIELDS, the enum its RAYLAB_NAMES?");
};

// ---- Without templates: each throws InputError where `json` is another value than is wanted -------------------------

double read_number(const JsonValue& json, const JsonPlace& place);

/// A number without a fraction, from `least` to `most`.
double read_whole(const JsonValue& json, double least, double most, const JsonPlace& place);

const std::string& read_word(const JsonValue& json, std::span<const std::string_view> words, const JsonPlace& place);

const JsonList& read_list(const JsonValue& json, const JsonPlace& place);

/// An object whose keys are all among `keys`, each at most once.
const JsonObject& read_object(const JsonValue& json, std::span<const std::string_view> keys, const JsonPlace& place);

/// The value of a field, or null if it is left out and may be.
const JsonValue* find_field(const JsonObject& object, const Field& field, const JsonPlace& place);

/// "one, two or three".
std::string alternatives(std::span<const std::string_view> words);

// ---- Numbers, booleans, vectors -------------------------------------------------------------------------------------

template <>
struct PlainJson<double> {
  static void read(const JsonValue& json, double& value, const JsonPlace& place) { value = read_number(json, place); }
  static void write(std::string& out, double value, NumberWriter number) { out += number(value); }
  static std::string describe() { return "number"; }
};

template <std::integral T>
struct PlainJson<T> {
  static void read(const JsonValue& json, T& value, const JsonPlace& place) {
    constexpr double exact = 0x1.fffffffffffffp+52;  // up to here a double is near to one whole number only
    constexpr auto least = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto most = static_cast<double>(std::numeric_limits<T>::max());
    value = static_cast<T>(read_whole(json, std::max(least, -exact), std::min(most, exact), place));
  }
  static void write(std::string& out, T value, NumberWriter) { out += std::to_string(value); }
  static std::string describe() { return "whole number"; }
};

template <>
struct PlainJson<bool> {
  static void read(const JsonValue& json, bool& value, const JsonPlace& place);
  static void write(std::string& out, bool value, NumberWriter) { out += value ? "true" : "false"; }
  static std::string describe() { return "true or false"; }
};

template <>
struct PlainJson<std::string> {
  static void read(const JsonValue& json, std::string& value, const JsonPlace& place);
  static void write(std::string& out, const std::string& value, NumberWriter) { out += json_string(value); }
  static std::string describe() { return "string"; }
};

/// And a Color.
template <>
struct PlainJson<Vec3> {
  static void read(const JsonValue& json, Vec3& value, const JsonPlace& place);
  static void write(std::string& out, const Vec3& value, NumberWriter number);
  static std::string describe() { return "[x, y, z]"; }
};

// ---- Enums ----------------------------------------------------------------------------------------------------------

template <class T>
requires std::is_enum_v<T>
struct PlainJson<T> {
  static void read(const JsonValue& json, T& value, const JsonPlace& place) {
    const std::string& word = read_word(json, names(), place);
    for_each_name(T{}, [&](std::string_view name, T named) {
      if (name == word) value = named;
    });
  }
  static void write(std::string& out, T value, NumberWriter) {
    for_each_name(T{}, [&](const char* name, T named) {
      if (named == value) out += json_string(name);
    });
  }
  static std::string describe() { return alternatives(names()); }

 private:
  static std::vector<std::string_view> names() {
    std::vector<std::string_view> all;
    for_each_name(T{}, [&](const char* name, T) { all.push_back(name); });
    return all;
  }
};

// ---- Lists and what may be missing ----------------------------------------------------------------------------------

template <class T>
struct PlainJson<std::vector<T>> {
  static void read(const JsonValue& json, std::vector<T>& value, const JsonPlace& place) {
    const JsonList& list = read_list(json, place);
    value.resize(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) PlainJson<T>::read(list[i], value[i], JsonPlace(place, i));
  }
  static void write(std::string& out, const std::vector<T>& value, NumberWriter number) {
    out += '[';
    for (const T& element : value) {
      if (&element != value.data()) out += ',';
      PlainJson<T>::write(out, element, number);
    }
    out += ']';
  }
  static std::string describe() { return "[" + PlainJson<T>::describe() + ", ...]"; }
};

template <class T>
struct PlainJson<std::optional<T>> {
  static void read(const JsonValue& json, std::optional<T>& value, const JsonPlace& place) {
    value.reset();
    if (!std::holds_alternative<std::nullptr_t>(json.data)) PlainJson<T>::read(json, value.emplace(), place);
  }
  static void write(std::string& out, const std::optional<T>& value, NumberWriter number) {
    if (value)
      PlainJson<T>::write(out, *value, number);
    else
      out += "null";
  }
  static std::string describe() { return PlainJson<T>::describe() + " or null"; }
};

// ---- Structs --------------------------------------------------------------------------------------------------------

/// Visits a field and does nothing. (A lambda in its place would make Clang 14 take every type for a struct.)
struct AnyField {
  void operator()(const Field&, const auto&) const {}
};
template <class T>
concept HasFields = requires(const T& object) {
  for_each_field(object, AnyField{});
};

template <HasFields T>
struct PlainJson<T> {
  /// Optional fields that are left out keep the value that they have.
  static void read(const JsonValue& json, T& value, const JsonPlace& place) {
    std::vector<std::string_view> keys;
    for_each_field(value, [&](const Field& field, auto&) { keys.push_back(field.name); });
    const JsonObject& object = read_object(json, keys, place);
    for_each_field(value, [&]<class Part>(const Field& field, Part& part) {
      const JsonValue* const found = find_field(object, field, place);
      if (found) PlainJson<Part>::read(*found, part, JsonPlace(place, std::string_view(field.name)));
    });
  }
  static void write(std::string& out, const T& value, NumberWriter number) {
    char before = '{';
    for_each_field(value, [&]<class Part>(const Field& field, const Part& part) {
      out += std::exchange(before, ',') + json_string(field.name) + ':';
      PlainJson<Part>::write(out, part, number);
    });
    out += '}';
  }
  static std::string describe() {
    std::string text;
    for_each_field(T{}, [&]<class Part>(const Field& field, const Part&) {
      text += (text.empty() ? "{" : ", ") + std::string(field.name) + (field.optional ? "?: " : ": ");
      text += PlainJson<Part>::describe();
    });
    return text + "}";
  }
};

// ---- Whole texts ----------------------------------------------------------------------------------------------------

/// `value` as JSON on one line, its numbers in as few digits as read back to the same.
template <class T>
std::string to_json(const T& value) {
  std::string out;
  PlainJson<T>::write(out, value, json_number);
  return out;
}

/// And back. Throws InputError.
template <class T>
T from_json(std::string_view text) {
  T value{};
  PlainJson<T>::read(parse_json(text), value, JsonPlace{});
  return value;
}

}  // namespace raylab
