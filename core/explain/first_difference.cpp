#include "core/explain/first_difference.hpp"

#include "core/calls/plain_json.hpp"

#include <cmath>
#include <exception>
#include <set>
#include <string_view>
#include <utility>

namespace raylab {
namespace {

constexpr double rounding = 1e-4;     // of the value, or of 1 if that is more: a power of 1000, in float
constexpr double moved_start = 2e-3;  // docs/model.md, accepted variants: 0.001, and as much room again

std::optional<double> number_of(const JsonValue& json) {
  if (const auto* number = std::get_if<double>(&json.data)) return *number;
  if (std::holds_alternative<std::string>(json.data)) try {
      return read_number(json, JsonPlace{});
    } catch (const InputError&) {
    }
  return std::nullopt;
}

bool close(double a, double b, double tolerance) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b || (std::isfinite(a) && std::abs(a - b) <= tolerance * std::max(1.0, std::abs(a)));
}

bool agree(const JsonValue& wanted, const JsonValue& got, double tolerance);

bool agree(const JsonList& wanted, const JsonList& got, double tolerance) {
  if (wanted.size() != got.size()) return false;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (!agree(wanted[k], got[k], tolerance)) return false;
  return true;
}

/// A ray of weight 0 means nothing.
bool is_nothing(const JsonObject& object) {
  for (const JsonMember& member : object)
    if (member.key == "weight" && number_of(member.value) == 0.0) return true;
  return false;
}

bool agree(const JsonObject& wanted, const JsonObject& got, double tolerance) {
  if (wanted.size() != got.size()) return false;
  if (is_nothing(wanted) && is_nothing(got)) return true;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const double here = wanted[k].key == "origin" ? std::max(tolerance, moved_start) : tolerance;
    if (wanted[k].key != got[k].key || !agree(wanted[k].value, got[k].value, here)) return false;
  }
  return true;
}

bool agree(const JsonValue& wanted, const JsonValue& got, double tolerance) {
  const std::optional<double> a = number_of(wanted), b = number_of(got);
  if (a && b) return close(*a, *b, tolerance);
  if (wanted.data.index() != got.data.index()) return false;
  if (const auto* list = std::get_if<JsonList>(&wanted.data)) return agree(*list, std::get<JsonList>(got.data), tolerance);
  if (const auto* object = std::get_if<JsonObject>(&wanted.data))
    return agree(*object, std::get<JsonObject>(got.data), tolerance);
  if (const auto* flag = std::get_if<bool>(&wanted.data)) return *flag == std::get<bool>(got.data);
  if (const auto* text = std::get_if<std::string>(&wanted.data)) return *text == std::get<std::string>(got.data);
  return true;  // both null
}

}  // namespace

bool answers_agree(const std::string& wanted, const std::string& got) {
  return wanted == got || agree(parse_json(wanted), parse_json(got), rounding);
}

std::optional<Difference> first_difference(const Recording& recording, const AskTask& ask) {
  std::set<std::pair<std::string_view, std::string_view>> asked;
  for (const Event& event : recording.events) {
    const auto* call = std::get_if<RecordedCall>(&event);
    if (!call || !asked.insert({call->task->label, call->arguments}).second) continue;
    try {
      const std::string got = ask(*call->task, call->arguments);
      if (!answers_agree(call->result, got)) return Difference{*call, got, {}};
    } catch (const std::exception& error) {
      return Difference{*call, {}, error.what()};
    }
  }
  return std::nullopt;
}

}  // namespace raylab
