#include "bench/report/images.hpp"

#include "bench/report/image_errors.hpp"
#include "bench/report/image_variants.hpp"
#include "bench/report/race.hpp"
#include "bench/variants/handout_renderer.hpp"
#include "core/render/render.hpp"
#include "reference/oracle/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace raylab::bench {
namespace {

constexpr int last_stage = 7;

const std::vector<AntiAliasing> timed_patterns{AntiAliasing::none, AntiAliasing::rotated4, AntiAliasing::adaptive};
const std::vector<AntiAliasing> sampled_patterns{AntiAliasing::none,   AntiAliasing::grid4,  AntiAliasing::rotated4,
                                                 AntiAliasing::grid16, AntiAliasing::grid64, AntiAliasing::adaptive};
constexpr AntiAliasing converged = AntiAliasing::grid1024;

/// What is large enough to time, small enough for the oracle, and shows edges.
ImageSize timed_size(const Plan& plan, const Scene& scene) {
  const bool slow = geometry_count(scene) > 100;  // to those that ask every geometry
  if (plan.quick) return slow ? ImageSize{80, 60} : ImageSize{120, 90};
  return slow ? ImageSize{160, 120} : ImageSize{240, 180};
}
ImageSize sampling_size(const Plan& plan) { return plan.quick ? ImageSize{80, 60} : ImageSize{160, 120}; }

/// The oracle asks every geometry: the more there are, the smaller the image, down to 8 x 6 pixels.
ImageSize error_size(const Plan& plan, const Scene& scene) {
  const int most = plan.quick ? 8 : 24;
  const double tests = plan.quick ? 4e5 : 2e6;
  const double tests_of_smallest = 48 * static_cast<double>(std::max<std::size_t>(1, geometry_count(scene)));
  const int times = std::clamp(static_cast<int>(std::sqrt(tests / tests_of_smallest)), 2, most);
  return {4 * times, 3 * times};
}

/// Beyond so many, only the engine by its own formulas is measured: whoever asks every geometry would take minutes for an
/// image, and each engine holds the scene once more.
constexpr std::size_t most_geometries_for_all = 2000;

Settings settings_of(const Scene& scene, ImageSize size, AntiAliasing aa) {
  return {last_stage, size, scene.max_bounces, aa};
}

struct Drawn {
  Image image;
  RenderTotals totals;
};

Drawn draw(const Engine& engine, ImageSize size, unsigned threads, const std::atomic<bool>& cancel) {
  Drawn drawn{{size.width, size.height}, {}};
  const auto keep = [&](int first_row, std::span<const Color> pixels) {
    const auto start = static_cast<std::ptrdiff_t>(first_row) * size.width;
    std::copy(pixels.begin(), pixels.end(), drawn.image.pixels.begin() + start);
  };
  drawn.totals = render(
      engine, size, threads, keep, [](double) {}, cancel);
  return drawn;
}

double samples_a_pixel(const Drawn& drawn) {
  return static_cast<double>(drawn.totals.rays.primary) / static_cast<double>(drawn.image.pixels.size());
}

/// Those that can draw the scene, in float the engine refuses what is beyond a float's range, and soon enough.
std::vector<ImageVariant> fit_for(const BenchScene& scene, ImageSize size, std::vector<ImageVariant> variants) {
  const bool many = geometry_count(scene.world) > most_geometries_for_all;
  std::erase_if(variants, [&](const ImageVariant& variant) {
    if (many && (variant.renderer != "fast" || variant.formulas != Formulas{})) return true;
    try {
      variant.make(scene.world, settings_of(scene.world, size, variant.aa));
      return false;
    } catch (const std::invalid_argument&) {
      return true;
    }
  });
  return variants;
}

// ---- The units ------------------------------------------------------------------------------------------------------

using Named = std::pair<std::string, std::unique_ptr<Engine>>;

/// How long each engine takes for its image, in this thread: {name: [seconds, ...]}.
Json time_engines(const std::vector<Named>& engines, ImageSize size, const Plan& plan, const std::atomic<bool>& cancel) {
  std::vector<Color> pixels(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  std::vector<std::function<void()>> contenders;
  for (const auto& [name, engine] : engines)
    contenders.push_back([&pixels, &cancel, &engine = *engine] {
      RayCounts counts;
      engine.trace_rows(0, pixels, counts, cancel);
    });
  const auto seconds = race(contenders, plan.quick ? 3 : 5, plan.quick ? 0.002 : 0.01, cancel);
  Json times;
  for (std::size_t k = 0; k < engines.size(); ++k) times[engines[k].first] = seconds[k];
  return times;
}

Json time_variants(const Plan& plan, const BenchScene& scene, AntiAliasing aa, const StageTable& stages,
                   const std::atomic<bool>& cancel) {
  const ImageSize size = timed_size(plan, scene.world);
  std::vector<Named> engines;
  for (const ImageVariant& variant : fit_for(scene, size, image_variants(stages, {aa})))
    engines.emplace_back(variant.id(), variant.make(scene.world, settings_of(scene.world, size, aa)));
  return time_engines(engines, size, plan, cancel);
}

Json time_patterns(const Plan& plan, const BenchScene& scene, const std::atomic<bool>& cancel) {
  const ImageSize size = sampling_size(plan);
  std::vector<Named> engines;
  for (const AntiAliasing aa : sampled_patterns)
    engines.emplace_back(aa_name(aa), make_fast(scene.world, settings_of(scene.world, size, aa), {}));
  return time_engines(engines, size, plan, cancel);
}

/// The errors of all variants with one pattern, and whether the instruction sets agree in every bit, by the engine's own
/// formulas.
Json arithmetic_errors(const Plan& plan, const BenchScene& scene, AntiAliasing aa, const StageTable& stages,
                       const std::atomic<bool>& cancel) {
  const ImageSize size = error_size(plan, scene.world);
  const Settings settings = settings_of(scene.world, size, aa);
  const Drawn right = draw(*make_oracle(scene.world, settings), size, plan.threads, cancel);
  const double pixels = static_cast<double>(right.image.pixels.size());
  Json found = {{"oracle_mpixels_per_second", pixels / 1e6 / right.totals.trace_seconds}, {"same_bits", true}};
  std::map<std::string, Image> images;
  for (const ImageVariant& variant : fit_for(scene, size, image_variants(stages, {aa}))) {
    const Drawn drawn = draw(*variant.make(scene.world, settings), size, plan.threads, cancel);
    found["variants"][variant.id()] = {{"samples", samples_a_pixel(drawn)},
                                       {"arithmetic", image_error(drawn.image, right.image)}};
    if (variant.formulas != Formulas{}) continue;  // spheres met by error depend on which ones were asked
    const Image& first = images.emplace(variant.arithmetic_id(), drawn.image).first->second;
    if (first.pixels != drawn.image.pixels) found["same_bits"] = false;
  }
  return found;
}

/// The errors of the patterns: [{"aa", "samples", "error"}].
Json sampling_errors(const Plan& plan, const BenchScene& scene, const std::atomic<bool>& cancel) {
  const ImageSize size = sampling_size(plan);
  const auto drawn = [&](AntiAliasing aa) {
    return draw(*make_fast(scene.world, settings_of(scene.world, size, aa), {}), size, plan.threads, cancel);
  };
  const Image right = drawn(converged).image;
  Json found = Json::array();
  for (const AntiAliasing aa : sampled_patterns) {
    const Drawn with = drawn(aa);
    found.push_back({{"aa", aa_name(aa)}, {"samples", samples_a_pixel(with)}, {"error", image_error(with.image, right)}});
  }
  return found;
}

struct Accepted {
  const char* text;
  Variant variant;
};

/// docs/errata.md, "Accepted variants", each at its farthest.
std::vector<Accepted> accepted_variants() {
  return {{"none: the textbook's renderer as it is", {}},
          {"shadow rays start 0.001 off their surface", {.shadow_shift = 0.001}},
          {"shadow rays start 0.1 off their surface", {.shadow_shift = 0.1}},
          {"bounced rays start 0.001 off their surface", {.bounce_shift = 0.001}},
          {"each dot product clamped by itself", {.clamp_each = true}},
          {"black where rounding makes a total reflection", {.black_rim = true}}};
}

Json model_errors(const Plan& plan, const BenchScene& scene, const std::atomic<bool>& cancel) {
  const ImageSize size = error_size(plan, scene.world);
  const Settings settings = settings_of(scene.world, size, AntiAliasing::none);
  const HandoutBuild build = handout_builds().front();
  const Image right = draw(*make_oracle(scene.world, settings), size, plan.threads, cancel).image;
  Json found = Json::array();
  for (const Accepted& accepted : accepted_variants()) {
    const Image image = draw(*build.make(scene.world, settings, accepted.variant), size, plan.threads, cancel).image;
    found.push_back({{"variant", accepted.text}, {"error", image_error(image, right)}});
  }
  return found;
}

// ---- The section ----------------------------------------------------------------------------------------------------

std::string unit_name(const BenchScene& scene, std::string_view part) {
  return "images/" + scene.name + "/" + std::string(part);
}

const Json* find(const Results& results, const std::string& name) {
  const auto found = results.find(name);
  return found == results.end() ? nullptr : &found->second;
}

/// Million pixels a second, from seconds.
Json speed_of(const Json& seconds, ImageSize size) {
  std::vector<double> speeds;
  for (const double one : seconds) speeds.push_back(1e-6 * size.width * size.height / one);
  return spread(std::move(speeds));
}

/// Marks what no other is both faster and better than.
template <class Speed, class Error>
void mark_front(Json& list, Speed speed, Error error) {
  for (Json& one : list) {
    one["on_front"] = std::none_of(list.begin(), list.end(), [&](const Json& other) {
      return speed(other) >= speed(one) && error(other) <= error(one) &&
             (speed(other) > speed(one) || error(other) < error(one));
    });
  }
}

double median_speed(const Json& one) { return one["mpixels_per_second"]["median"]; }

Json variants_of(const Plan& plan, const BenchScene& scene, const Results& results, const std::vector<ImageVariant>& known) {
  Json all = Json::array();
  for (const AntiAliasing aa : timed_patterns) {
    const Json* const times = find(results, unit_name(scene, "speed " + std::string(aa_name(aa))));
    const Json* const errors = find(results, unit_name(scene, "arithmetic " + std::string(aa_name(aa))));
    if (times == nullptr || errors == nullptr) continue;
    Json with_aa = Json::array();
    for (const ImageVariant& variant : known) {
      if (variant.aa != aa || !times->contains(variant.id())) continue;
      with_aa.push_back({{"id", variant.id()},
                         {"renderer", variant.renderer},
                         {"precision", variant.precision},
                         {"simd", variant.simd.empty() ? Json() : Json(variant.simd)},
                         {"sphere", variant.formulas.sphere == SphereFormula::foot ? "foot" : "textbook"},
                         {"power", variant.formulas.power == PowerFormula::log1p ? "log1p" : "cosine"},
                         {"aa", aa_name(aa)},
                         {"samples", (*errors)["variants"][variant.id()]["samples"]},
                         {"mpixels_per_second", speed_of((*times)[variant.id()], timed_size(plan, scene.world))},
                         {"arithmetic", (*errors)["variants"][variant.id()]["arithmetic"]}});
    }
    mark_front(with_aa, median_speed, [](const Json& one) -> double { return one["arithmetic"]["rmse_judged"]; });
    for (Json& one : with_aa) all.push_back(std::move(one));
  }
  return all;
}

Json sampling_of(const Plan& plan, const BenchScene& scene, const Results& results) {
  const Json* const errors = find(results, unit_name(scene, "sampling"));
  const Json* const times = find(results, unit_name(scene, "sampling speed"));
  if (errors == nullptr || times == nullptr) return Json::array();
  Json all = *errors;
  for (Json& one : all) one["mpixels_per_second"] = speed_of((*times)[one["aa"].get<std::string>()], sampling_size(plan));
  mark_front(all, median_speed, [](const Json& one) -> double { return one["error"]["rmse"]; });
  return all;
}

Json json_of(ImageSize size) { return Json::array({size.width, size.height}); }

Json scene_report(const Plan& plan, const BenchScene& scene, const Results& results,
                  const std::vector<ImageVariant>& known) {
  const Json* const model = find(results, unit_name(scene, "model"));
  Json report = {{"scene", scene.name},
                 {"hard", scene.hard},
                 {"timed_size", json_of(timed_size(plan, scene.world))},
                 {"error_size", json_of(error_size(plan, scene.world))},
                 {"same_bits", true},
                 {"oracle_mpixels_per_second", nullptr}};
  for (const AntiAliasing aa : timed_patterns)
    if (const Json* const errors = find(results, unit_name(scene, "arithmetic " + std::string(aa_name(aa))))) {
      if (!(*errors)["same_bits"]) report["same_bits"] = false;
      if (aa == AntiAliasing::none) report["oracle_mpixels_per_second"] = (*errors)["oracle_mpixels_per_second"];
    }
  report["variants"] = variants_of(plan, scene, results, known);
  report["sampling"] = sampling_of(plan, scene, results);
  report["model"] = model == nullptr ? Json::array() : *model;
  return report;
}

}  // namespace

std::vector<Unit> image_units(const Plan& plan, const std::vector<BenchScene>& scenes, const StageTable& stages) {
  std::vector<Unit> units;
  for (const BenchScene& scene : scenes) {
    const auto add = [&](const std::string& part, double seconds, auto measure) {
      units.push_back({unit_name(scene, part), plan.quick ? seconds / 8 : seconds, std::move(measure)});
    };
    using Cancel = const std::atomic<bool>&;
    for (const AntiAliasing aa : timed_patterns) {
      const std::string with_aa = " " + std::string(aa_name(aa));
      const double samples = aa == AntiAliasing::none ? 1 : 4;
      add("speed" + with_aa, 4 * samples,
          [plan, &scene, &stages, aa](Cancel cancel) { return time_variants(plan, scene, aa, stages, cancel); });
      add("arithmetic" + with_aa, 3 * samples,
          [plan, &scene, &stages, aa](Cancel cancel) { return arithmetic_errors(plan, scene, aa, stages, cancel); });
    }
    add("sampling", 3, [plan, &scene](Cancel cancel) { return sampling_errors(plan, scene, cancel); });
    add("sampling speed", 4, [plan, &scene](Cancel cancel) { return time_patterns(plan, scene, cancel); });
    add("model", 4, [plan, &scene](Cancel cancel) { return model_errors(plan, scene, cancel); });
  }
  return units;
}

Json image_report(const Plan& plan, const std::vector<BenchScene>& scenes, const Results& results) {
  const std::vector<ImageVariant> known = image_variants({}, timed_patterns);
  Json report = {{"sampling_size", json_of(sampling_size(plan))},
                 {"converged_samples", sample_offsets(converged).size()},
                 {"scenes", Json::array()}};
  for (const BenchScene& scene : scenes) report["scenes"].push_back(scene_report(plan, scene, results, known));
  return report;
}

}  // namespace raylab::bench
