#include "bench/report/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace raylab::bench {
namespace {

constexpr double least_change_of_time = 0.05;
constexpr double least_change_of_error = 1e-6;
constexpr double spreads = 3;

std::string key_of(const Figure& figure) {
  return figure.section + '\n' + figure.subject + '\n' + figure.variant + '\n' + figure.what;
}

double ratio_of(double before, double after) {
  if (before == after) return 1;
  return before == 0 ? std::numeric_limits<double>::infinity() : after / before;
}

/// What noise may change a time by, as a part of it: a standard deviation from the quartiles, as of a normal distribution.
double noise_of(const Figure& time) { return (*time.high - *time.low) / (1.349 * std::abs(time.value)); }

bool has_changed(const Figure& before, const Figure& after) {
  if (!before.low || !after.low)
    return std::abs(after.value - before.value) >
           least_change_of_error * std::max(std::abs(before.value), std::abs(after.value));
  const double noise = std::hypot(noise_of(before), noise_of(after));
  return std::abs(std::log(ratio_of(before.value, after.value))) > std::max(spreads * noise, least_change_of_time);
}

void sort_by_size(std::vector<Change>& changes) {
  const auto size = [](const Change& change) { return std::abs(std::log(change.ratio)); };
  std::stable_sort(changes.begin(), changes.end(), [&](const Change& a, const Change& b) { return size(a) > size(b); });
}

double median(std::vector<double> values) {
  if (values.empty()) return 1;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void require_report(const Json& report) {
  if (!report.is_object() || report.value("format", "") != "raylab bench 1")
    throw NoReport("not a report of raylab bench: it should have \"format\": \"raylab bench 1\"");
}

std::vector<std::string> differences_of_runs(const Json& before, const Json& after) {
  std::vector<std::string> sentences;
  for (const char* const field : {"mode", "processor", "cores", "compiler", "build", "flags", "simd"}) {
    const Json a = before.value(field, Json()), b = after.value(field, Json());
    if (a != b) sentences.push_back(std::string(field) + ": " + a.dump() + ", then " + b.dump());
  }
  return sentences;
}

/// Was more than a tenth of the times noisy?
bool is_noisy(const Json& report) {
  const Json noise = report.value("noise", Json::object());
  return 10 * noise.value("noisy", 0.0) > noise.value("times", 0.0);
}

/// The scenes that both reports have, but not the same: another file, or in images of another size.
std::vector<std::string> differences_of_scenes(const Json& before, const Json& after) {
  std::vector<std::string> words;
  for (const Json& was : before)
    for (const Json& is : after) {
      if (was["scene"] != is["scene"]) continue;
      for (const char* const field : {"sha1", "timed_size", "error_size"})
        if (was.value(field, Json()) != is.value(field, Json()))
          words.push_back("the " + std::string(field) + " of " + is["scene"].get<std::string>());
    }
  return words;
}

std::vector<std::string> subjects_of(const std::set<std::string>& keys) {
  std::set<std::string> subjects;
  for (const std::string& key : keys) {
    const std::size_t first = key.find('\n'), second = key.find('\n', first + 1), third = key.find('\n', second + 1);
    subjects.insert(key.substr(0, first) + ": " + key.substr(first + 1, second - first - 1) + ": " +
                    key.substr(second + 1, third - second - 1));
  }
  return {subjects.begin(), subjects.end()};
}

}  // namespace

ReportChanges compare_reports(const Json& before, const Json& after) {
  require_report(before);
  require_report(after);
  ReportChanges found;
  found.runs_differ = differences_of_runs(before.value("header", Json::object()), after.value("header", Json::object()));

  for (const auto& [a, b] : {std::pair(before.value("/header/scenes"_json_pointer, Json::array()),
                                       after.value("/header/scenes"_json_pointer, Json::array())),
                             std::pair(before.value("/images/scenes"_json_pointer, Json::array()),
                                       after.value("/images/scenes"_json_pointer, Json::array()))})
    for (std::string& words : differences_of_scenes(a, b)) found.runs_differ.push_back(std::move(words));
  found.too_noisy = is_noisy(before) || is_noisy(after);

  std::map<std::string, Figure> first;
  for (Figure& figure : figures_of(before)) first.emplace(key_of(figure), figure);
  std::set<std::string> only_after;
  std::vector<double> slower;
  for (const Figure& now : figures_of(after)) {
    const auto then = first.find(key_of(now));
    if (then == first.end()) {
      only_after.insert(key_of(now));
      continue;
    }
    const Figure was = then->second;
    first.erase(then);
    const double ratio = ratio_of(was.value, now.value);
    const bool timed = now.low.has_value() && was.low.has_value();
    ++(timed ? found.times : found.errors);
    if (timed) slower.push_back(now.more_is_better ? 1 / ratio : ratio);
    if ((timed && found.too_noisy) || !has_changed(was, now)) continue;
    (timed ? found.changed_times : found.changed_errors).push_back({was, now, ratio, now.more_is_better == (ratio > 1)});
  }
  std::set<std::string> only_before;
  for (const auto& [key, figure] : first) only_before.insert(key);
  found.only_before = subjects_of(only_before);
  found.only_after = subjects_of(only_after);
  found.timing_ratio = median(std::move(slower));
  sort_by_size(found.changed_times);
  sort_by_size(found.changed_errors);
  return found;
}

}  // namespace raylab::bench
