#include "tests/hints/observed.hpp"

#include "core/calls/json_value.hpp"
#include "core/calls/plain_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <sstream>
#include <utility>

namespace raylab::test {
namespace {

/// The vectors and single numbers of an answer, but for what a ray leaves; vectors have three numbers.
struct Parts {
  std::vector<std::vector<double>> numbers;
  bool nothing = false;  ///< null
  std::optional<bool> flag;
};

void collect(const JsonValue& value, Parts& parts) {
  if (const auto* number = std::get_if<double>(&value.data)) parts.numbers.push_back({*number});
  if (const auto* text = std::get_if<std::string>(&value.data)) try {
      parts.numbers.push_back({parse_number(*text)});
    } catch (const InputError&) {  // the name of a side
    }
  if (const auto* list = std::get_if<JsonList>(&value.data)) {
    const bool vector =
        list->size() == 3 && std::all_of(list->begin(), list->end(), [](const JsonValue& element) {
          return std::holds_alternative<double>(element.data) || std::holds_alternative<std::string>(element.data);
        });
    if (!vector) {
      for (const JsonValue& element : *list) collect(element, parts);
      return;
    }
    parts.numbers.emplace_back();
    for (const JsonValue& element : *list) parts.numbers.back().push_back(read_number(element, JsonPlace{}));
  }
  if (const auto* object = std::get_if<JsonObject>(&value.data))
    for (const JsonMember& member : *object)
      if (member.key != "leaves" && member.key != "origin") collect(member.value, parts);
}

Parts parts_of(const std::string& json) {
  const JsonValue value = parse_json(json);
  Parts parts;
  parts.nothing = std::holds_alternative<std::nullptr_t>(value.data);
  if (const auto* flag = std::get_if<bool>(&value.data)) parts.flag = *flag;
  collect(value, parts);
  return parts;
}

using Numbers = std::vector<double>;

bool close(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || a == b || std::abs(a - b) <= 1e-4 * std::max({1.0, std::abs(a), std::abs(b)});
}

/// Is `got` what `change` makes of `wanted`, in every pair that differs at all? And is there one?
bool always(const std::vector<std::pair<Numbers, Numbers>>& pairs, const std::function<Numbers(const Numbers&)>& change) {
  bool any = false;
  for (const auto& [wanted, got] : pairs) {
    const Numbers changed = change(wanted);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (!close(changed[k], got[k])) return false;
      any = any || !close(wanted[k], got[k]);
    }
  }
  return any;
}

Numbers scaled(Numbers v, double factor) {
  for (double& x : v) x *= factor;
  return v;
}

std::string number(double value) {
  std::ostringstream stream;
  stream.precision(4);
  stream << value;
  return stream.str();
}

/// The one factor by which all differ, if there is one.
std::optional<double> common_factor(const std::vector<std::pair<Numbers, Numbers>>& pairs) {
  for (const auto& [wanted, got] : pairs)
    for (std::size_t k = 0; k < wanted.size(); ++k)
      if (std::abs(wanted[k]) > 1e-3 && std::isfinite(got[k])) {
        const double factor = got[k] / wanted[k];
        if (always(pairs, [factor](const Numbers& v) { return scaled(v, factor); })) return factor;
        return std::nullopt;
      }
  return std::nullopt;
}

std::string pattern_of_numbers(const std::vector<std::pair<Numbers, Numbers>>& pairs) {
  if (const auto factor = common_factor(pairs)) {
    if (close(*factor, -1)) return "Every answer has the opposite sign.";
    if (close(*factor, 0)) return "Every answer is zero.";
    return "Every answer is " + number(*factor) + " times the right one.";
  }
  const auto unit = [](Numbers v) {
    double squares = 0;
    for (const double x : v) squares += x * x;
    return squares > 0 ? scaled(v, 1 / std::sqrt(squares)) : v;
  };
  const bool vectors = std::all_of(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.first.size() == 3; });
  const bool directions_wanted = vectors && std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
                                   const Numbers& v = pair.first;
                                   return close(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 1);
                                 });
  if (vectors) {
    std::vector<std::pair<Numbers, Numbers>> directions;
    for (const auto& [wanted, got] : pairs) directions.emplace_back(unit(wanted), unit(got));
    const auto same = [](const Numbers& v) { return v; };
    if (directions_wanted && !always(directions, same) &&
        std::all_of(directions.begin(), directions.end(), [&](const auto& pair) {
          return close(pair.first[0], pair.second[0]) && close(pair.first[1], pair.second[1]) &&
                 close(pair.first[2], pair.second[2]);
        }))
      return "Every direction is right, but its length is not.";
    const std::array<const char*, 3> axes{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (always(pairs, [axis](Numbers v) { return v[axis] = -v[axis], v; }))
        return std::string("Every answer has the opposite sign in ") + axes[axis] + ", and is right otherwise.";
      const std::size_t next = (axis + 1) % 3;
      if (always(pairs, [axis, next](Numbers v) { return std::swap(v[axis], v[next]), v; }))
        return std::string("In every answer ") + axes[axis] + " and " + axes[next] + " have changed places.";
    }
  }
  if (always(pairs, [](Numbers v) {
        for (double& x : v) x = std::clamp(x, 0.0, 1.0);
        return v;
      }))
    return "Every answer is the right one, clamped to 0..1.";
  if (std::all_of(pairs.begin(), pairs.end(), [](const auto& pair) {
        return std::any_of(pair.second.begin(), pair.second.end(), [](double x) { return !std::isfinite(x); });
      }))
    return "Every wrong answer is not a finite number.";
  return "";
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + (count == 1 ? one : many);
}

}  // namespace

std::string common_pattern(const std::vector<WrongAnswer>& wrong) {
  std::vector<std::pair<Numbers, Numbers>> pairs;
  std::size_t missed = 0, invented = 0, said_yes = 0, said_no = 0, errors = 0;
  for (const WrongAnswer& answer : wrong) {
    if (!answer.error.empty()) {
      ++errors;
      continue;
    }
    const Parts wanted = parts_of(answer.wanted), got = parts_of(answer.got);
    missed += got.nothing && !wanted.nothing;
    invented += wanted.nothing && !got.nothing;
    said_yes += got.flag == true && wanted.flag == false;
    said_no += got.flag == false && wanted.flag == true;
    if (wanted.numbers.size() != got.numbers.size()) continue;
    for (std::size_t k = 0; k < wanted.numbers.size(); ++k)
      if (wanted.numbers[k].size() == got.numbers[k].size()) pairs.emplace_back(wanted.numbers[k], got.numbers[k]);
  }
  std::string text;
  const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (missed > 0) add(counted(missed, " time", " times") + " it says \"nothing\" where there is something.");
  if (invented > 0) add(counted(invented, " time", " times") + " it finds something where there is nothing.");
  if (said_yes > 0) add(counted(said_yes, " time", " times") + " it says true where false is right.");
  if (said_no > 0) add(counted(said_no, " time", " times") + " it says false where true is right.");
  if (errors > 0) add(counted(errors, " time", " times") + " it gives no answer at all.");
  if (const std::string pattern = pairs.empty() ? "" : pattern_of_numbers(pairs); !pattern.empty()) add(pattern);
  return text;
}

}  // namespace raylab::test
