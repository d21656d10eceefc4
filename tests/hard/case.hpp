#pragma once

#include "tests/support.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <set>
#include <string>

namespace raylab::test::hard {

/// Whose functions are asked, and to what they round.
struct Asked {
  StageTable table;
  double u = 0x1p-53;
  std::set<std::string> without_answer = {};  ///< cases where the functions throw std::domain_error

  bool single_precision() const { return u > 0x1p-53; }
};

/// A number, or a string that C's strtod reads: "0x1.8p+0", "inf", 25 digits.
double number(const nlohmann::json& value);
Vec3 vector(const nlohmann::json& value);

/// One case of tests/data/hard_cases.json, put to somebody, with what its test needs to read from it.
struct Case {
  nlohmann::json data;
  const Asked& asked;

  std::string id() const { return data["id"]; }
  std::string tolerance_class() const { return data["tolerance_class"]; }
  std::string expected_kind() const { return data["expected"]["kind"]; }
  double input(const char* name) const { return number(data["inputs"][name]); }
  Vec3 input_vector(const char* name) const { return vector(data["inputs"][name]); }
  double expected(const char* name) const { return number(data["expected"][name]); }
  Vec3 expected_vector(const char* name) const { return vector(data["expected"][name]); }

  const StageTable& table() const { return asked.table; }
  double u() const { return asked.u; }

  /// The error that the class allows, relative to the answer: meta.tolerance_classes.
  double tolerance() const;
};

void check_value(const Case& c, double actual, double expected);
void check_vector(const Case& c, const Vec3& actual, const Vec3& expected);

/// Does the scene reader refuse a scene with these lines after a good camera?
bool refused(const std::string& lines, const std::string& camera = "position = [0,0,0]\nfacing = [0,0,-1]\nup = [0,1,0]\n");

/// A number or a vector of a case's `inputs_dec` as scene files have it.
std::string toml(const nlohmann::json& value);

/// What only the driver or the image writer can answer stands in their own tests, named where this stands.
inline void elsewhere(const Case&) {}

/// What each operation of a case asks.
using Tests = std::map<std::string, std::function<void(const Case&)>>;

Tests tests_of_rays_and_shapes();      // stages 1 and 2
Tests tests_of_light();                // 3 and 4
Tests tests_of_bounces_and_samples();  // 5 to 7

}  // namespace raylab::test::hard
