#include "core/calls/json_value.hpp"

#include "core/scene/diagnostic.hpp"
#include "core/scene/read_decimal.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace raylab {
namespace {

using nlohmann::json;

/// Builds a JsonValue from what the parser meets. The library's own values would lose the sign of -0 and all but the last of
/// the members with one key.
class Builder : public json::json_sax_t {
 public:
  JsonValue take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value == 0 ? -0.0 : static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) override { return add(static_cast<double>(value)); }
  bool number_float(double value, const std::string& text) override { return add(parse_decimal(text).value_or(value)); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(json::binary_t&) override { return false; }  // not in a text

  bool start_object(std::size_t) override { return open(JsonObject{}); }
  bool start_array(std::size_t) override { return open(JsonList{}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& key) override {
    key_ = std::move(key);
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
    std::string_view text = error.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    for (const std::string_view prefix : {"] ", "parse error at "})
      if (const std::size_t start = text.find(prefix); start != text.npos) text.remove_prefix(start + prefix.size());
    text = text.substr(0, text.find("; last read"));  // which may be the whole line
    throw InputError("this is no JSON: " + printable(text.substr(0, 200)));
  }

 private:
  JsonValue& place(JsonValue&& value) {
    if (open_.empty()) return root_ = std::move(value);
    if (auto* list = std::get_if<JsonList>(&open_.back()->data)) return list->emplace_back(std::move(value));
    return std::get<JsonObject>(open_.back()->data).emplace_back(JsonMember{std::move(key_), std::move(value)}).value;
  }

  template <class Data>
  bool add(Data&& data) {
    place({std::forward<Data>(data)});
    return true;
  }

  /// What is open does not move: only the innermost grows.
  template <class Data>
  bool open(Data&& data) {
    constexpr std::size_t deepest = 32;
    if (open_.size() == deepest) throw InputError("more than " + std::to_string(deepest) + " levels of brackets");
    open_.push_back(&place({std::forward<Data>(data)}));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  JsonValue root_{};
  std::vector<JsonValue*> open_;
  std::string key_;
};

/// "nan", "inf" or "-inf", as a JSON string.
std::string not_finite(double number) { return json_string(to_text(number)); }

/// The shortest text that reads back as the same double, decimal if no format is given.
template <class... Format>
std::string shortest(double number, Format... format) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, format...).ptr;
  return std::string(buffer.data(), end);
}

/// Of "0x1.8p+0" or "-0x1.8p+0"; infinity for what is beyond the range of a double, at either end.
std::optional<double> parse_hex(std::string_view text) {
  const bool negative = text.front() == '-';
  const std::string_view digits = text.substr(negative ? 3 : 2);
  if (digits.find_first_of("-iInN") == 0) return std::nullopt;  // from_chars would take a second sign, inf and nan
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::hex);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) number = std::numeric_limits<double>::infinity();
  return negative ? -number : number;
}

}  // namespace

JsonValue parse_json(std::string_view text) {
  if (text.find('\0') != text.npos) throw InputError("this is no JSON: it has a NUL byte");  // the parser would end there
  Builder builder;
  json::sax_parse(text, &builder);
  return builder.take();
}

std::string json_string(std::string_view text) { return json(text).dump(-1, ' ', false, json::error_handler_t::replace); }

std::string json_number(double number) {
  if (!std::isfinite(number)) return not_finite(number);
  const std::string text = shortest(number);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

std::string json_hex_number(double number) {
  if (!std::isfinite(number)) return not_finite(number);
  return (std::signbit(number) ? "\"-0x" : "\"0x") + shortest(std::abs(number), std::chars_format::hex) + '"';
}

double parse_number(std::string_view text) {
  const bool hex = text.starts_with("0x") || text.starts_with("-0x");
  const std::optional<double> number = hex ? parse_hex(text) : parse_decimal(text);
  if (!number) throw InputError("wanted a number, got the string " + quoted(text));
  const bool has_digits = text.find_first_of("0123456789") != text.npos;
  if (std::isinf(*number) && has_digits) throw InputError(quoted(text) + " is beyond the range of a double");
  return *number;
}

}  // namespace raylab
