#include "bench/report/choices.hpp"

#include "bench/report/image_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <vector>

namespace raylab::bench {
namespace {

constexpr double visible = 0.5 / 255;  // half a step of an image's 255
constexpr double comparable = 1e-9;

/// A variant on all scenes where it was measured.
struct Candidate {
  std::string id;
  Json any;  ///< one of its entries
  std::map<std::string, Json> ordinary, hard;
};

double speed(const Json& entry) { return entry["mpixels_per_second"]["median"]; }

double slowest(const Candidate& candidate) {
  double least = speed(candidate.ordinary.begin()->second);
  for (const auto& [scene, entry] : candidate.ordinary) least = std::min(least, speed(entry));
  return least;
}

double fastest(const Candidate& candidate) {
  double most = 0;
  for (const auto& [scene, entry] : candidate.ordinary) most = std::max(most, speed(entry));
  return most;
}

double worst_error(const std::map<std::string, Json>& entries) {
  double worst = 0;
  for (const auto& [scene, entry] : entries) worst = std::max(worst, entry["arithmetic"]["max_rest"].get<double>());
  return worst;
}

bool keeps(const Json& error, double bound) {
  return error["max_rest"] <= bound && error["non_finite"] == 0 &&
         error["flipped"].get<double>() <= most_flipped * error["pixels"].get<double>();
}

/// What --engine and --precision can choose: no textbook formulas.
bool on_offer(const Json& entry) {
  const bool textbook = entry["sphere"] == "textbook" || entry["power"] == "cosine";
  return entry["aa"] == "none" && !textbook;
}

/// By which scenes a pick is made: the ordinary ones; all, where all are hard.
std::vector<const Json*> judging_scenes(const Json& images) {
  std::vector<const Json*> all, ordinary;
  for (const Json& scene : images["scenes"]) {
    all.push_back(&scene);
    if (!scene["hard"]) ordinary.push_back(&scene);
  }
  return ordinary.empty() ? all : ordinary;
}

/// Those that were measured on all scenes that judge, the fastest first.
std::vector<Candidate> candidates_of(const Json& images) {
  const std::vector<const Json*> judging = judging_scenes(images);
  std::map<std::string, Candidate> by_id;
  for (const Json& scene : images["scenes"]) {
    const bool judges = std::find(judging.begin(), judging.end(), &scene) != judging.end();
    for (const Json& entry : scene["variants"]) {
      if (!on_offer(entry)) continue;
      Candidate& candidate = by_id[entry["id"]];
      candidate.id = entry["id"];
      candidate.any = entry;
      (judges ? candidate.ordinary : candidate.hard)[scene["scene"]] = entry;
    }
  }
  std::vector<Candidate> candidates;
  for (auto& [id, candidate] : by_id)
    if (candidate.ordinary.size() == judging.size()) candidates.push_back(std::move(candidate));
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return slowest(a) > slowest(b); });
  return candidates;
}

template <class... Numbers>
std::string print(const char* format, Numbers... numbers) {
  char text[400];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// "1.4 to 1.9", or "1.4" where that is the same.
std::string range(double least, double most) {
  const std::string low = print("%.3g", least), high = print("%.3g", most);
  return low == high ? low : low + " to " + high;
}

std::string options_of(const Json& entry) {
  return "--engine " + entry["renderer"].get<std::string>() +
         (entry["renderer"] == "fast" ? " --precision " + entry["precision"].get<std::string>() : "");
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string hard_sentence(const Candidate& candidate, double bound) {
  std::vector<std::string> good, bad;
  for (const auto& [scene, entry] : candidate.hard) (keeps(entry["arithmetic"], bound) ? good : bad).push_back(scene);
  if (candidate.hard.empty()) return "No hard scene was measured.";
  if (bad.empty()) return "It keeps that bound on the hard scenes too: " + listed(good) + ".";
  return (good.empty() ? "On none of the hard scenes does it keep that bound: " : "Not on these hard scenes: ") +
         listed(bad) + ".";
}

std::string pick_sentence(const Candidate& candidate) {
  const double error = worst_error(candidate.ordinary);
  std::string text = range(slowest(candidate), fastest(candidate)) +
                     " million pixels a second on one core, off by at most " + print("%.2g of white", error);
  if (error > 1e-5) text += print(" (%.2g of the 255 steps)", 255 * error);
  if (!candidate.any["simd"].is_null()) text += ", with " + candidate.any["simd"].get<std::string>();
  return text + ".";
}

/// How many times as fast one is as the other: the least and the most of the scenes that both were measured on.
std::string times_as_fast(const Candidate& one, const Candidate& other) {
  double least = 0, most = 0;
  for (const auto& [scene, entry] : one.ordinary) {
    const auto found = other.ordinary.find(scene);
    if (found == other.ordinary.end()) continue;
    const double ratio = speed(entry) / speed(found->second);
    least = least == 0 ? ratio : std::min(least, ratio);
    most = std::max(most, ratio);
  }
  return range(least, most) + " times as fast as " + options_of(other.any) + ".";
}

/// The fastest that keeps the bound on every ordinary scene; the end if there is none.
std::vector<Candidate>::const_iterator pick_within(const std::vector<Candidate>& candidates, double bound) {
  return std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
    return std::all_of(candidate.ordinary.begin(), candidate.ordinary.end(),
                       [&](const auto& on_scene) { return keeps(on_scene.second["arithmetic"], bound); });
  });
}

Json choice_within(const std::vector<Candidate>& candidates, const char* need, double bound, const std::string& bound_text) {
  const auto picked = pick_within(candidates, bound);
  if (picked == candidates.end())
    return {{"need", need},
            {"bound", bound_text},
            {"pick", nullptr},
            {"sentence", "Nothing that was measured keeps this bound on all ordinary scenes."},
            {"hard_sentence", nullptr}};
  return {{"need", need},
          {"bound", bound_text},
          {"pick", options_of(picked->any)},
          {"sentence", pick_sentence(*picked)},
          {"hard_sentence", hard_sentence(*picked, bound)}};
}

/// Where nothing but the truth will do.
Json oracle_choice(const Json& images) {
  double least = 0, most = 0;
  for (const Json& scene : images["scenes"]) {
    if (scene["oracle_mpixels_per_second"].is_null()) continue;
    const double one = scene["oracle_mpixels_per_second"];
    least = least == 0 ? one : std::min(least, one);
    most = std::max(most, one);
  }
  return {{"need", "the truth, to tell who is wrong"},
          {"bound", "each component is the double nearest to the model's"},
          {"pick", "--engine oracle"},
          {"sentence", range(least, most) + " million pixels a second on one core."},
          {"hard_sentence", "It is what all others were compared with, on the hard scenes too."}};
}

/// The best of the patterns that halve the error of one sample on every ordinary scene and are within a tenth of the fastest
/// of these.
Json sampling_choice(const Json& images) {
  std::map<std::string, double> worst_gain, least_speed, most_samples;
  for (const Json* const judging : judging_scenes(images)) {
    const Json& scene = *judging;
    if (scene["sampling"].empty() || scene["sampling"][0]["error"]["rmse"] == 0.0) continue;  // nothing to smooth
    const double alone = scene["sampling"][0]["error"]["rmse"];
    for (const Json& pattern : scene["sampling"]) {
      const std::string aa = pattern["aa"];
      const double gain = alone / pattern["error"]["rmse"].get<double>(), fast = speed(pattern);
      const bool known = worst_gain.contains(aa);
      worst_gain[aa] = known ? std::min(worst_gain[aa], gain) : gain;
      least_speed[aa] = known ? std::min(least_speed[aa], fast) : fast;
      most_samples[aa] = std::max(most_samples[aa], pattern["samples"].get<double>());
    }
  }
  Json choice = {{"need", "smooth edges"},
                 {"bound", "half the sampling error of one sample a pixel, or less"},
                 {"pick", nullptr},
                 {"sentence", "No pattern that was measured halves the error on all ordinary scenes."},
                 {"hard_sentence", nullptr}};
  double fastest_good = 0, best = 0;
  for (const auto& [aa, gain] : worst_gain)
    if (gain >= 2) fastest_good = std::max(fastest_good, least_speed[aa]);
  for (const auto& [aa, gain] : worst_gain) {
    if (gain < 2 || least_speed[aa] < 0.9 * fastest_good || gain <= best) continue;
    best = gain;
    choice["pick"] = "--aa " + aa;
    choice["sentence"] = (std::isinf(gain) ? "No error is left" : print("%.2g times less error or better", gain)) +
                         print(", for up to %.3g samples a pixel.", most_samples[aa]);
  }
  return choice;
}

}  // namespace

Json choices_from(const Json& images) {
  const std::vector<Candidate> candidates = candidates_of(images);
  if (candidates.empty()) return Json::array();
  const std::string flips = " Up to one pixel in a thousand may fall on the other side of an edge.";
  Json to_look_at = choice_within(candidates, "a picture to look at", visible,
                                  "no component off by more than half a step of 255." + flips);
  Json to_compare =
      choice_within(candidates, "numbers to compare with", comparable, "no component off by more than 1e-9." + flips);
  const auto fast = pick_within(candidates, visible), precise = pick_within(candidates, comparable);
  if (precise != candidates.end() && fast != precise)
    to_look_at["sentence"] = to_look_at["sentence"].get<std::string>() + " " + times_as_fast(*fast, *precise);
  return Json::array({to_look_at, to_compare, oracle_choice(images), sampling_choice(images)});
}

}  // namespace raylab::bench
