#pragma once

#include "core/calls/plain_json.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace raylab {

/// What an argument is kept in until the call: a list for a span.
template <class Parameter>
struct Kept {
  using Type = std::remove_cvref_t<Parameter>;
};
template <class T>
struct Kept<std::span<const T>> {
  using Type = std::vector<T>;
};

/// An argument as it is kept.
template <class T>
const T& keep(const T& argument) {
  return argument;
}
template <class T>
std::vector<T> keep(std::span<const T> argument) {
  return {argument.begin(), argument.end()};
}

/// Arguments as a JSON object, under `names`: what call_function() reads.
template <class... Parameters>
std::string arguments_json(const std::vector<std::string>& names, const Parameters&... arguments) {
  std::string out;
  [[maybe_unused]] auto name = names.begin();
  [[maybe_unused]] const auto write = [&]<class Value>(const Value& value) {
    out += (out.empty() ? "{" : ",") + json_string(*name++) + ':';
    PlainJson<Value>::write(out, value, json_number);
  };
  (write(keep(arguments)), ...);
  return out.empty() ? "{}" : out + '}';
}

template <class Value>
void read_argument(const JsonObject& arguments, const std::string& name, Value& value) {
  const JsonValue* const found = find_field(arguments, Field{name.c_str(), false}, JsonPlace{});
  PlainJson<Value>::read(*found, value, JsonPlace(JsonPlace{}, std::string_view(name)));
}

/// Calls `function` with the arguments that stand in a JSON object under `names`, one for each parameter.
/// Throws InputError if they do not, and whatever the function throws.
template <class Result, class... Parameters>
Result call_function(Result (*function)(Parameters...), const std::vector<std::string>& names, const JsonValue& arguments) {
  const std::vector<std::string_view> keys(names.begin(), names.end());
  const JsonObject& object = read_object(arguments, keys, JsonPlace{});
  std::tuple<typename Kept<Parameters>::Type...> values;
  std::apply(
      [&](auto&... value) {
        [[maybe_unused]] auto name = names.begin();
        (read_argument(object, *name++, value), ...);
      },
      values);
  return std::apply([&](const auto&... value) { return function(value...); }, values);
}

}  // namespace raylab
