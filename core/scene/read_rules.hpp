#pragma once

#include <array>
#include <cmath>
#include <span>

namespace raylab {

/// What a number in a scene file must be: a test, and the words for a number that fails it.
struct Rule {
  bool (*holds)(double);
  const char* wanted;
};

using Rules = std::span<const Rule>;

inline constexpr Rule must_be_finite{[](double x) { return std::isfinite(x); }, "must be a finite number"};
inline constexpr Rule is_number{[](double x) { return !std::isnan(x); }, "must be a number"};
inline constexpr Rule not_negative{[](double x) { return x >= 0; }, "must be at least 0"};
inline constexpr Rule positive{[](double x) { return x > 0; }, "must be greater than 0"};

// The ranges of docs/model.md, "Scene files", one list for each kind of number; the first rule that fails is the one named.
inline constexpr std::array direction_rules{must_be_finite};
inline constexpr std::array coordinate_rules{
    must_be_finite, Rule{[](double x) { return std::abs(x) <= 1e100; }, "must be between -1e100 and 1e100"}};
inline constexpr std::array radius_rules{
    must_be_finite, positive, Rule{[](double x) { return x >= 1e-100 && x <= 1e100; }, "must be between 1e-100 and 1e100"}};
inline constexpr std::array color_rules{must_be_finite, not_negative};
inline constexpr std::array intensity_rules{must_be_finite, not_negative};
inline constexpr std::array shininess_rules{is_number, not_negative};
inline constexpr std::array refractive_index_rules{
    must_be_finite, Rule{[](double x) { return x >= 0.1 && x <= 10; }, "must be between 0.1 and 10"}};
inline constexpr std::array field_of_view_rules{
    must_be_finite, Rule{[](double x) { return x > 0 && x < 90; }, "must be greater than 0 and less than 90"}};

/// The words of the first rule that `number` breaks; null if it keeps them all.
inline const char* first_broken(Rules rules, double number) {
  for (const Rule& rule : rules) {
    if (!rule.holds(number)) return rule.wanted;
  }
  return nullptr;
}

}  // namespace raylab
