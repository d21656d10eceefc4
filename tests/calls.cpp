// JSON of plain data, both ways, and calls of tasks with it: core/calls.

#include "core/calls/call_function.hpp"
#include "core/calls/call_task.hpp"
#include "core/math/hit.hpp"
#include "core/math/material.hpp"
#include "tests/support.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

template <class T>
std::string written(const T& value, NumberWriter number = json_number) {
  std::string json;
  PlainJson<T>::write(json, value, number);
  return json;
}

template <class T>
T read(const std::string& json, T value = {}) {
  PlainJson<T>::read(parse_json(json), value, JsonPlace{});
  return value;
}

/// What is wrong with a text as a T; empty if nothing is.
template <class T>
std::string mistake(const std::string& json) {
  try {
    read<T>(json);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::uint64_t bits(double number) {
  std::uint64_t result = 0;
  std::memcpy(&result, &number, sizeof result);
  return result;
}

/// Does a value survive the way to JSON and back, in decimal and in hexadecimal?
template <class T>
void check_there_and_back(const T& value, const std::string& json) {
  CHECK(written(value) == json);
  CHECK(written(read<T>(json)) == json);
  CHECK(written(read<T>(written(value, json_hex_number))) == json);
}

const TaskInfo& task(std::string_view label) {
  for (const TaskInfo& info : task_list())
    if (info.label == label) return info;
  throw std::logic_error("no such task");
}

std::string answer(std::string_view label, std::string_view arguments) {
  return TaskCaller(table(), task(label)).answer(arguments).json;
}

const Leaves inside_third{3, Side::inwards};
const std::string ray_text =
    R"({"origin":[1.0,2.0,3.0],"direction":[0.0,0.0,-1.0],"leaves":{"geometry":3,"side":"inwards"}})";

}  // namespace

TEST_CASE("calls: every type goes to JSON and back", "[calls]") {
  check_there_and_back(0.1, "0.1");
  check_there_and_back(true, "true");
  check_there_and_back(-7, "-7");
  check_there_and_back(std::size_t{5}, "5");
  check_there_and_back(Side::inwards, "\"inwards\"");
  check_there_and_back(Vec3(1, 2.5, -3), "[1.0,2.5,-3.0]");
  check_there_and_back(std::optional<double>(2), "2.0");
  check_there_and_back(std::optional<double>(), "null");
  check_there_and_back(std::vector<Color>{Color(0), Color(1)}, "[[0.0,0.0,0.0],[1.0,1.0,1.0]]");
  check_there_and_back(std::vector<int>{}, "[]");
  check_there_and_back(std::vector<std::optional<double>>{1, {}}, "[1.0,null]");
  check_there_and_back(Ray{{1, 2, 3}, {0, 0, -1}, inside_third}, ray_text);
  check_there_and_back(std::vector<Candidate>{{1, 2}, {}}, R"([{"geometry":1,"t":2.0},{"geometry":-1,"t":null}])");
  check_there_and_back(Bounce{{{1, 2, 3}, {0, 0, -1}, inside_third}, 0.5}, R"({"ray":)" + ray_text + R"(,"weight":0.5})");
}

TEST_CASE("calls: every double goes to JSON and back, decimal and hexadecimal, with its sign", "[calls]") {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  for (const double number :
       {0.0, -0.0, 0.1, -1.0 / 3, 1e23, 1e300, least, -least, 0x1.8p-1040, most, 5e-324, infinity, -infinity})
    for (const auto writer : {json_number, json_hex_number}) {
      INFO(writer(number));
      CHECK(bits(read<double>(writer(number))) == bits(number));
    }
  CHECK(std::isnan(read<double>(json_number(std::nan("")))));
  CHECK(json_number(-std::nan("")) == "\"nan\"");
  CHECK(json_hex_number(1.5) == "\"0x1.8p+0\"");
  CHECK(json_hex_number(-0.0) == "\"-0x0p+0\"");
  CHECK(json_number(1e300) == "1e+300");
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const double number = std::ldexp(random.between(-1, 1), static_cast<int>(random.between(-1080, 1020)));
    CHECK(bits(read<double>(json_number(number))) == bits(number));
    CHECK(bits(read<double>(json_hex_number(number))) == bits(number));
  }
}

TEST_CASE("calls: a number is the double nearest to its text", "[calls]") {
  // Ties, and texts just beside them, of more digits than a double has.
  for (const char* text :
       {"9007199254740993", "9007199254740992.99999999999999999999", "9007199254740993.00000000000000000001",
        "18446744073709551616", "2.4703282292062327208299439634110764e-324", "2.47032822920623272e-324", "1e-400",
        "1.7976931348623158e308", "0.1e1", "-0", "-0.0"}) {
    INFO(text);
    CHECK(bits(read<double>(text)) == bits(std::strtod(text, nullptr)));
    CHECK(bits(read<double>('"' + std::string(text) + '"')) == bits(std::strtod(text, nullptr)));
  }
  for (const char* text :
       {"0x1.00000000000008p+0", "0x1.000000000000080001p+0", "0x1.00000000000018p0", "0x1.8p-1074", "-0xAp-3", "0x.8p1"}) {
    INFO(text);
    CHECK(bits(read<double>('"' + std::string(text) + '"')) == bits(std::strtod(text, nullptr)));
  }
}

TEST_CASE("calls: what is no number, or beyond a double, is refused", "[calls]") {
  for (const char* text :
       {"", " 1", "1 ", "1x", "1e", "0x", "0x-1p0", "--1", "+1", "0xinf", "0xnan", "0x1p", "0x1.8p+0 ", "one"}) {
    INFO(text);
    CHECK(mistake<double>('"' + std::string(text) + '"') == "wanted a number, got the string '" + std::string(text) + "'");
  }
  for (const char* text : {"1e400", "-1e400", "0x1p+1024", "0x1p-1080"})
    CHECK(mistake<double>('"' + std::string(text) + '"') == "'" + std::string(text) + "' is beyond the range of a double");
  CHECK(mistake<double>("1e400") == "this is no JSON: number overflow parsing '1e400'");
}

TEST_CASE("calls: fields with a default may be left out, others not", "[calls]") {
  CHECK(written(read<Ray>(R"({"origin": [1,2,3], "direction": [0,0,-1]})")) ==
        R"({"origin":[1.0,2.0,3.0],"direction":[0.0,0.0,-1.0],"leaves":{"geometry":-1,"side":"outwards"}})");
  CHECK(written(read<Material>(R"({"color": [1,1,1]})")) ==
        R"({"color":[1.0,1.0,1.0],"shininess":0.0,"transparent":false,"refractive_index":1.5})");
  CHECK(read<Candidate>("{}").t == miss);
  CHECK(read<Candidate>("{}", {5, 2}).t == 2.0);
  CHECK(read<Candidate>(R"({"t": null})", {5, 2}).t == miss);
  CHECK(mistake<Ray>(R"({"origin": [1,2,3]})") == "direction: is missing");
  CHECK(mistake<Leaves>(R"({"side": "inwards"})") == "geometry: is missing");
}

TEST_CASE("calls: a mistake is told with its place", "[calls]") {
  using Bounces = std::vector<Bounce>;
  const auto in_ray = [](const std::string& ray) { return R"([{"ray": )" + ray + R"(, "weight": 1}])"; };
  CHECK(mistake<Bounces>(R"({"ray": 1})") == "wanted a list, got an object");
  CHECK(mistake<Bounces>("[[]]") == "[0]: wanted an object, got a list");
  CHECK(mistake<Bounces>(in_ray("null")) == "[0].ray: wanted an object, got null");
  CHECK(mistake<Bounces>(in_ray(R"({"origin": 7})")) == "[0].ray.origin: wanted a list of 3 numbers, got 7");
  CHECK(mistake<Bounces>(in_ray(R"({"origin": [1, 2]})")) == "[0].ray.origin: wanted a list of 3 numbers, got 2");
  CHECK(mistake<Bounces>(in_ray(R"({"origin": [1, 2, {}]})")) == "[0].ray.origin[2]: wanted a number, got an object");
  CHECK(mistake<Bounces>(in_ray(R"({"origin": [1, 2, "x"]})")) == "[0].ray.origin[2]: wanted a number, got the string 'x'");
  CHECK(mistake<Bounces>(in_ray(R"({"orign": 7})")) == "[0].ray.orign: unknown key, did you mean 'origin'?");
  CHECK(mistake<Bounces>(in_ray(R"({"xyz": 7})")) == "[0].ray.xyz: unknown key; known keys: origin, direction, leaves");
  CHECK(mistake<Bounces>(R"([{"weight": 1, "weight": 1}])") == "[0].weight: is there twice");
  CHECK(mistake<Crossing>(R"({"t": 1, "transparent": 1})") == "transparent: wanted true or false, got 1");
  CHECK(mistake<Leaves>(R"({"geometry": 1, "side": "in"})") == "side: wanted outwards or inwards, got the string 'in'");
  CHECK(mistake<Leaves>(R"({"geometry": 1.5})") ==
        "geometry: wanted a whole number from -2147483648 to 2147483647, got 1.5");
  CHECK(mistake<double>("true") == "wanted a number, got true");
}

TEST_CASE("calls: a whole number keeps to its type and to what a double can tell", "[calls]") {
  CHECK(read<int>("2147483647") == 2147483647);
  CHECK(read<int>("-2147483648") == -2147483647 - 1);
  CHECK(read<int>("7.0") == 7);
  CHECK(read<int>("\"0x1p+3\"") == 8);
  for (const char* text : {"2147483648", "-2147483649", "0.5", "\"nan\"", "\"inf\"", "1e300"}) {
    INFO(text);
    CHECK(mistake<int>(text).starts_with("wanted a whole number from -2147483648 to 2147483647, got "));
  }
  CHECK(read<std::size_t>("9007199254740991") == 9007199254740991);
  CHECK(mistake<std::size_t>("9007199254740993") ==
        "wanted a whole number from 0 to 9007199254740991, got 9007199254740992");
}

TEST_CASE("calls: what is no JSON is refused", "[calls]") {
  for (const char* text : {"", "{", "[1,]", "{\"a\":}", "[1] 2", "nul", "[01]", "[.5]", "[1.]", "[+1]", "[NaN]", "\"\xff\"",
                           "[\"\\ud800\"]", "\"\x01\"", "// 1", "'a'"}) {
    INFO(text);
    CHECK(mistake<std::vector<double>>(text).starts_with("this is no JSON: "));
  }
  CHECK(mistake<double>("[1,]") ==
        "this is no JSON: line 1, column 4: syntax error while parsing value - unexpected ']'; "
        "expected '[', '{', or a literal");
  CHECK(mistake<double>(std::string("1\0 2", 4)) == "this is no JSON: it has a NUL byte");
  CHECK(mistake<double>(std::string(32, '[') + std::string(32, ']')) == "wanted a number, got a list");
  CHECK(mistake<double>(std::string(33, '[') + std::string(33, ']')) == "more than 32 levels of brackets");
  CHECK(mistake<double>(std::string(1000000, '[')) == "more than 32 levels of brackets");
  CHECK(mistake<double>('"' + std::string(1000000, 'x')).size() < 200);
}

TEST_CASE("calls: what is hidden in a string cannot break an answer", "[calls]") {
  CHECK(TaskCaller(table(), task("5.1")).mistake("\"\\\n\xff\x1b").json ==
        "{\"task\":\"5.1\",\"error\":\"\\\"\\\\\\n\xef\xbf\xbd\\u001b\"}");
  CHECK(answer("5.1", R"({"\n\u0000\"": 1})") == R"({"task":"5.1","error":"\\x0a\\x00\": unknown key; known keys: d, n"})");
}

TEST_CASE("calls: every task's example has an answer, and its signature the same parameters", "[calls]") {
  for (const TaskInfo& info : task_list()) {
    INFO(info.label << ' ' << info.example);
    const CallAnswer answered = TaskCaller(table(), info).answer(info.example);
    INFO(answered.json);
    CHECK(answered.good);
    CHECK(std::string(info.example).find('\'') == std::string::npos);  // it stands in a shell's quotes
    CHECK_FALSE(signature_of(info).result.empty());
  }
  CHECK(signature_of(task("2.1")).parameters[0].type ==
        "{origin: [x, y, z], direction: [x, y, z], leaves?: {geometry: whole number, side?: outwards or inwards}}");
  CHECK(signature_of(task("2.4")).parameters[0].type == "[{geometry?: whole number, t?: number or null}, ...]");
  CHECK(signature_of(task("3.3")).parameters[0].name == "light");
  CHECK(signature_of(task("5.2")).result.find('?') == std::string::npos);
  CHECK(signature_of(task("2.4")).result == "whole number or null");
  CHECK(signature_of(task("5.3")).result == "true or false");
}

TEST_CASE("calls: an answer has the result twice, and the task", "[calls]") {
  CHECK(answer("2.2", task("2.2").example) == R"({"task":"2.2","name":"sphere_hit","result":4.0,"hex":"0x1p+2"})");
  CHECK(answer("5.3", task("5.3").example) == R"({"task":"5.3","name":"go_on","result":true,"hex":true})");
  CHECK(answer("2.1",
               R"({"ray": {"origin": [0,1,0], "direction": [1,0,0]}, "plane": {"point": [0,0,0], "normal": [0,1,0]}})") ==
        R"({"task":"2.1","name":"plane_hit","result":null,"hex":null})");
  CHECK(answer("3.6", R"({"contributions": [["nan", "inf", "-inf"]]})") ==
        R"({"task":"3.6","name":"sum_lights","result":["nan","inf","-inf"],"hex":["nan","inf","-inf"]})");
}

TEST_CASE("calls: a mistake, and what a function throws, is an answer", "[calls]") {
  CHECK(answer("2.2", "{}") == R"({"task":"2.2","error":"ray: is missing"})");
  CHECK(answer("2.2", "[]") == R"({"task":"2.2","error":"wanted an object, got a list"})");
  CHECK(answer("7.1", R"({"a": 1})") == R"({"task":"7.1","error":"a: unknown key; none are known here"})");
  CHECK(answer("3.1", R"({"shinines": 1})") ==
        R"({"task":"3.1","error":"shinines: unknown key, did you mean 'shininess'?"})");
  StageTable broken;
  CHECK(TaskCaller(broken, task("3.1")).answer(R"({"shininess": 1})").json ==
        R"({"task":"3.1","error":"task 3.1 is not in this implementation"})");
  broken.specular_weight = [](double) -> double { throw NotWritten("task 3.1 is not written yet"); };
  CHECK(TaskCaller(broken, task("3.1")).answer(R"({"shininess": 1})").json ==
        R"({"task":"3.1","error":"task 3.1 is not written yet"})");
  broken.specular_weight = [](double) -> double { throw 7; };
  CHECK_FALSE(TaskCaller(broken, task("3.1")).answer(R"({"shininess": 1})").good);
}

TEST_CASE("calls: arguments reach their own parameters, in any order", "[calls]") {
  const auto difference = [](double a, const Vec3& b, std::span<const double> c) { return a - b.x - c[1]; };
  double (*function)(double, const Vec3&, std::span<const double>) = difference;
  const JsonValue arguments = parse_json(R"({"c": [9, 0.5], "a": 10, "b": [2, 9, 9]})");
  CHECK(call_function(function, {"a", "b", "c"}, arguments) == 7.5);
}
