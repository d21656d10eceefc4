#include "tests/hard/case.hpp"

#include "core/scene/read_scene.hpp"

#include <algorithm>
#include <cstdlib>

namespace raylab::test::hard {

using nlohmann::json;

double number(const json& value) {
  return value.is_string() ? std::strtod(value.get<std::string>().c_str(), nullptr) : value.get<double>();
}

Vec3 vector(const json& value) { return {number(value[0]), number(value[1]), number(value[2])}; }

double Case::tolerance() const {
  if (tolerance_class() == "exact") return 0;
  if (tolerance_class() == "cond") return 8 * number(data["condition"]) * u();
  return 8 * u();
}

void check_value(const Case& c, double actual, double expected) {
  INFO("got " << text(actual) << ", wanted " << text(expected));
  CHECK(std::abs(actual - expected) <= c.tolerance() * std::abs(expected));
}

void check_vector(const Case& c, const Vec3& actual, const Vec3& expected) {
  INFO("got " << text(actual) << ", wanted " << text(expected));
  CHECK(length(actual - expected) <= std::max(c.tolerance(), 4 * c.u()) * length(expected));
}

bool refused(const std::string& lines, const std::string& camera) {
  return !parse_scene("[camera]\n" + camera + lines, "hard.toml").scene.has_value();
}

std::string toml(const json& value) {
  if (!value.is_array()) return value.get<std::string>();
  return "[" + value[0].get<std::string>() + "," + value[1].get<std::string>() + "," + value[2].get<std::string>() + "]";
}

}  // namespace raylab::test::hard
