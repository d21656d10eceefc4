#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raylab {

/// What is wrong with an input that somebody wrote, and where: "sphere.radius: wanted a number, got an object".
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct JsonValue;
struct JsonMember;

using JsonList = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>;

/// What a JSON text says, unabridged: the members of an object in their order, one that is there twice as well.
struct JsonValue {
  std::variant<std::nullptr_t, bool, double, std::string, JsonList, JsonObject> data;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

/// Reads a whole text of JSON. A number is the double nearest to what is written, and -0 keeps its sign.
/// Throws InputError for what is no JSON or no UTF-8, a number beyond the range of a double, and more than 32 levels of
/// brackets. Survives any bytes.
JsonValue parse_json(std::string_view text);

/// `text` as a JSON string. Bytes that are no UTF-8 are replaced.
std::string json_string(std::string_view text);

/// The shortest decimal that reads back as `number`, with a point or an exponent, so that every reader sees a floating-point
/// number: 4.0. "nan", "inf" and "-inf" are strings, as JSON has no such numbers.
std::string json_number(double number);

/// `number` as C's %a writes it, a string: "0x1.8p+0"; or "nan", "inf", "-inf". Independent of the locale, as the other is.
std::string json_hex_number(double number);

/// The double nearest to the number in a string: "0x1.8p+0", "-1.5e3", "inf", "-inf" or "nan".
/// Throws InputError, whose text says what is wrong, if the whole of it is not a number that a double can be near to.
double parse_number(std::string_view text);

}  // namespace raylab
