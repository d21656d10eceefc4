#pragma once

#include "core/math/fields.hpp"
#include "core/math/hit.hpp"
#include "core/math/vec3.hpp"

#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

namespace raylab::bench {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;
template <class T>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;

/// Takes the plain data that tasks take and return apart, in order. Calls
///
///     visit.number(x)     for each double,
///     visit.vector(v)     for each direction, color or place,
///     visit.point(p)      for the place where a ray starts,
///     visit.decision(k)   for what is right or wrong: a whole number, a bool, a side, whether there is a value, how many.
///
/// The first three can set what they are given if `value` is not const.
template <class Value, class Visitor>
void walk_value(Value& value, Visitor&& visit) {
  using Plain = std::remove_const_t<Value>;
  const auto walk = [&](auto& part) { walk_value(part, visit); };
  if constexpr (std::same_as<Plain, double>) {
    visit.number(value);
  } else if constexpr (std::same_as<Plain, Vec3>) {
    visit.vector(value);
  } else if constexpr (std::integral<Plain> || std::is_enum_v<Plain>) {
    visit.decision(static_cast<long>(value));
  } else if constexpr (is_optional<Plain>) {
    visit.decision(value.has_value());
    if (value) walk(*value);
  } else if constexpr (is_list<Plain>) {
    visit.decision(static_cast<long>(value.size()));
    for (auto& part : value) walk(part);
  } else if constexpr (is_tuple<Plain>) {
    std::apply([&](auto&... parts) { (walk(parts), ...); }, value);
  } else if constexpr (std::same_as<Plain, Ray>) {
    visit.point(value.origin);
    visit.vector(value.direction);
    walk(value.leaves);
  } else if constexpr (std::same_as<Plain, GlassBounces>) {
    // At total reflection the refracted ray means nothing.
    const bool refracts = value.refracted.weight != 0;
    walk(value.reflected);
    visit.decision(refracts);
    if (refracts) walk(value.refracted);
  } else {
    for_each_field(value, [&](const Field&, auto& part) { walk(part); });
  }
}

}  // namespace raylab::bench
