#include "bench/report/growth.hpp"

#include "bench/report/growth_scenes.hpp"
#include "bench/report/race.hpp"
#include "core/image/terminal.hpp"
#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <thread>

namespace raylab::bench {
namespace {

ImageSize frame(const Plan& plan) { return plan.quick ? ImageSize{160, 120} : ImageSize{320, 240}; }
int rounds(const Plan& plan) { return plan.quick ? 3 : 7; }
double least_seconds(const Plan& plan) { return plan.quick ? 0.002 : 0.01; }

using MakeEngine = std::function<std::unique_ptr<Engine>(const Scene&, const Settings&)>;

/// Who is measured: the fast engine in both precisions, the stages' functions.
struct Curve {
  std::string name;
  MakeEngine make;
};

std::vector<Curve> curves(const StageTable& stages) {
  const auto fast = [](Precision precision) -> MakeEngine {
    return
        [=](const Scene& scene, const Settings& settings) { return make_fast(scene, settings, {.precision = precision}); };
  };
  return {
      {"fast f32", fast(Precision::f32)},
      {"fast f64", fast(Precision::f64)},
      {"stages", [&stages](const Scene& scene, const Settings& settings) { return make_stages(scene, settings, stages); }}};
}

/// A frame to time: who draws it, and how. The scene outlives the engine that is made from it.
struct Frame {
  std::string name;
  std::shared_ptr<const Scene> scene;
  Settings settings;
  std::unique_ptr<Engine> engine;
  unsigned threads = 1;
  std::vector<double> prepare_seconds = {};  ///< of a few times
  std::size_t bytes = 0;                     ///< that preparing took
};

Frame make_frame(const std::string& name, std::shared_ptr<const Scene> scene, const Settings& settings,
                 const MakeEngine& make, int times = 1) {
  Frame frame{name, std::move(scene), settings, {}};
  for (int time = 0; time < times; ++time) {
    frame.engine.reset();
    const std::size_t before = memory_in_use();
    const double start = thread_seconds();
    frame.engine = make(*frame.scene, settings);
    frame.prepare_seconds.push_back(thread_seconds() - start);
    const std::size_t after = memory_in_use();
    if (after > before) frame.bytes = std::max(frame.bytes, after - before);
  }
  return frame;
}

/// {name: {"seconds": [...], "prepare_seconds", "bytes"}}, the frames in turn.
Json time_frames(const std::vector<Frame>& frames, const Plan& plan, const std::atomic<bool>& cancel,
                 double (*clock)() = thread_seconds) {
  std::vector<std::function<void()>> contenders;
  std::vector<Color> pixels;
  for (const Frame& one : frames) {
    const ImageSize size = one.settings.size;
    pixels.resize(std::max(pixels.size(), static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)));
    contenders.push_back([&, size] {
      RayCounts counts;
      const auto count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
      if (one.threads == 1)
        one.engine->trace_rows(0, std::span(pixels).first(count), counts, cancel);
      else
        render(
            *one.engine, size, one.threads, [](int, std::span<const Color>) {}, [](double) {}, cancel);
    });
  }
  const auto seconds = race(contenders, rounds(plan), least_seconds(plan), cancel, clock);
  Json times;
  for (std::size_t k = 0; k < frames.size(); ++k)
    times[frames[k].name] = {
        {"seconds", seconds[k]}, {"prepare_seconds", frames[k].prepare_seconds}, {"bytes", frames[k].bytes}};
  return times;
}

// ---- Series ---------------------------------------------------------------------------------------------------------

/// One variable that frames grow with, and its values.
struct Series {
  const char* id;
  const char* title;
  const char* x;  ///< what the variable counts
  const char* text;
  bool log;
  bool prepared;  ///< are the time and the memory of preparing worth telling?
  std::vector<std::size_t> values;
  std::size_t most_for_stages;  ///< the largest value that the stages' functions are asked for
  std::function<std::shared_ptr<const Scene>(std::size_t)> scene;
  std::function<void(Settings&, std::size_t)> settings;
};

std::shared_ptr<const Scene> share(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

std::vector<Series> all_series(const Plan& plan) {
  const auto as_it_is = [](Settings&, std::size_t) {};
  std::vector<Series> all;
  all.push_back(
      {"spheres",
       "Spheres",
       "spheres",
       "The more spheres, the smaller: they always fill as much of their cube. From 24 on the engine has a hierarchy; the "
       "stages' functions ask every sphere.",
       true,
       true,
       {10, 100, 1000, 10'000, 100'000, 1'000'000},
       plan.quick ? 100u : 1000u,
       [](std::size_t n) { return share(many_spheres(n)); },
       as_it_is});
  all.push_back({"lights",
                 "Lights",
                 "point lights",
                 "Five spheres on a plane: each light is a shadow ray for each point.",
                 true,
                 false,
                 {1, 2, 4, 8, 16, 32},
                 32,
                 [](std::size_t n) { return share(many_lights(static_cast<int>(n))); },
                 as_it_is});
  all.push_back({"bounces",
                 "Bounces",
                 "bounces",
                 "Perfect mirrors face each other, so that rays end only where they must.",
                 false,
                 false,
                 {0, 1, 2, 4, 8, 16, 32},
                 32,
                 [](std::size_t) { return share(mirrors()); },
                 [](Settings& settings, std::size_t n) { settings.max_bounces = static_cast<int>(n); }});
  all.push_back({"pixels",
                 "Image size",
                 "pixels",
                 "Five spheres on a plane.",
                 true,
                 false,
                 {4800, 19'200, 76'800, 307'200, 1'228'800},
                 76'800,
                 [](std::size_t) { return share(five_spheres({.plane = true})); },
                 [](Settings& settings, std::size_t n) {
                   const double width = std::sqrt(static_cast<double>(n) * 4 / 3);
                   settings.size = {static_cast<int>(width + 0.5), static_cast<int>(0.75 * width + 0.5)};
                 }});
  return all;
}

std::string unit_name(const Series& series, std::size_t value) {
  return "growth/" + std::string(series.id) + "/" + std::to_string(value);
}

Json measure_value(const Plan& plan, const Series& series, std::size_t value, const StageTable& stages,
                   const std::atomic<bool>& cancel) {
  const std::shared_ptr<const Scene> scene = series.scene(value);
  Settings settings{7, frame(plan), scene->max_bounces, AntiAliasing::none};
  series.settings(settings, value);
  std::vector<Frame> frames;
  for (const Curve& curve : curves(stages))
    if (curve.name != "stages" || value <= series.most_for_stages)
      frames.push_back(make_frame(curve.name, scene, settings, curve.make, series.prepared && !plan.quick ? 3 : 1));
  return time_frames(frames, plan, cancel);
}

/// The slope of log time over log x over the upper half of the points, by least squares; null if these are fewer than three.
Json exponent_of(const Json& points) {
  const std::size_t count = points.size(), half = std::max<std::size_t>(3, (count + 1) / 2);
  if (count < half) return nullptr;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = count - half; k < count; ++k) {
    const double log_x = std::log(points[k]["x"].get<double>());
    const double log_y = std::log(points[k]["seconds"]["median"].get<double>());
    n += 1, x += log_x, y += log_y, xx += log_x * log_x, xy += log_x * log_y;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

Json series_report(const Series& series, const Results& results) {
  Json curves_of_series = Json::array();
  for (const std::string name : {"fast f32", "fast f64", "stages"}) {
    Json points = Json::array();
    for (const std::size_t value : series.values) {
      const auto found = results.find(unit_name(series, value));
      if (found == results.end() || !found->second.contains(name)) continue;
      const Json& measured = found->second[name];
      points.push_back({{"x", value},
                        {"seconds", spread(measured["seconds"])},
                        {"prepare_seconds", series.prepared ? spread(measured["prepare_seconds"]) : Json()},
                        {"bytes", series.prepared ? measured["bytes"] : Json()}});
    }
    if (points.empty()) continue;
    curves_of_series.push_back(
        {{"name", name}, {"exponent", series.log ? exponent_of(points) : Json()}, {"points", std::move(points)}});
  }
  return {{"id", series.id},     {"title", series.title}, {"x", series.x},
          {"text", series.text}, {"log", series.log},     {"curves", std::move(curves_of_series)}};
}

// ---- Threads --------------------------------------------------------------------------------------------------------

std::vector<unsigned> thread_counts() {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<unsigned> counts;
  for (unsigned n = 1; n < cores; n *= 2) counts.push_back(n);
  counts.push_back(cores);
  return counts;
}

/// By the time that passes, all in one race.
Json measure_threads(const Plan& plan, const std::atomic<bool>& cancel) {
  const auto scene = share(many_spheres(10'000));
  const ImageSize size = plan.quick ? ImageSize{320, 240} : ImageSize{960, 720};
  std::vector<Frame> frames;
  for (const unsigned threads : thread_counts()) {
    frames.push_back(make_frame(std::to_string(threads), scene, {7, size, 0, AntiAliasing::none},
                                [](const Scene& s, const Settings& settings) { return make_fast(s, settings, {}); }));
    frames.back().threads = threads;
  }
  return time_frames(frames, plan, cancel, wall_seconds);
}

Json threads_report(const Json& measured) {
  Json points = Json::array();
  for (const unsigned threads : thread_counts())
    points.push_back({{"x", threads},
                      {"seconds", spread(measured[std::to_string(threads)]["seconds"])},
                      {"prepare_seconds", nullptr},
                      {"bytes", nullptr}});
  return {{"id", "threads"},
          {"title", "Threads"},
          {"x", "threads"},
          {"text", "Ten thousand spheres; the time that passes, where all else here is processor time."},
          {"log", true},
          {"curves", Json::array({{{"name", "fast f64"}, {"exponent", exponent_of(points)}, {"points", points}}})}};
}

// ---- Features -------------------------------------------------------------------------------------------------------

/// A frame without and one with something.
struct Feature {
  const char* name;
  const char* text;
  Scene without, with;
  int stage_without = 7, stage_with = 7;
  AntiAliasing aa_with = AntiAliasing::none;
};

std::vector<Feature> all_features() {
  const Scene plain = five_spheres();
  Scene mirrorless = five_spheres({.mirror = true});
  mirrorless.max_bounces = 0;
  return {{"plane", "a floor under five matte spheres", plain, five_spheres({.plane = true})},
          {"highlights", "one sphere of the five is shiny, without bounces", plain, five_spheres({.highlights = true})},
          {"mirror", "that sphere reflects", mirrorless, five_spheres({.mirror = true})},
          {"glass", "one sphere is of glass", plain, five_spheres({.glass = true})},
          {"shadows", "stage 4 after stage 3", plain, plain, 3, 4},
          {"directional light", "a second light", plain, five_spheres({.directional_light = true})},
          {"four samples", "the rotated grid", plain, plain, 7, 7, AntiAliasing::rotated4},
          {"adaptive samples", "more where four disagree", plain, plain, 7, 7, AntiAliasing::adaptive}};
}

Json measure_features(const Plan& plan, const std::atomic<bool>& cancel) {
  const auto fast = [](const Scene& s, const Settings& settings) {
    return make_fast(s, settings, {.precision = Precision::f32});
  };
  std::vector<Frame> frames;
  for (const Feature& feature : all_features()) {
    const std::string name = feature.name;
    frames.push_back(make_frame(name + " without", share(feature.without),
                                {feature.stage_without, frame(plan), feature.without.max_bounces, AntiAliasing::none},
                                fast));
    frames.push_back(make_frame(name + " with", share(feature.with),
                                {feature.stage_with, frame(plan), feature.with.max_bounces, feature.aa_with}, fast));
  }
  return time_frames(frames, plan, cancel);
}

Json features_report(const Json& measured) {
  Json all = Json::array();
  for (const Feature& feature : all_features()) {
    const std::string name = feature.name;
    all.push_back({{"feature", name},
                   {"text", feature.text},
                   {"without", spread(measured[name + " without"]["seconds"])},
                   {"with", spread(measured[name + " with"]["seconds"])}});
  }
  return all;
}

}  // namespace

std::vector<Unit> growth_units(const Plan& plan, const StageTable& stages) {
  std::vector<Unit> units;
  for (const Series& series : all_series(plan))
    for (const std::size_t value : series.values)
      units.push_back({unit_name(series, value), plan.quick ? 0.1 : 2, [=, &stages](const std::atomic<bool>& cancel) {
                         return measure_value(plan, series, value, stages, cancel);
                       }});
  units.push_back({"growth/threads", plan.quick ? 0.5 : 4,
                   [plan](const std::atomic<bool>& cancel) { return measure_threads(plan, cancel); }});
  units.push_back({"growth/features", plan.quick ? 0.5 : 4,
                   [plan](const std::atomic<bool>& cancel) { return measure_features(plan, cancel); }});
  return units;
}

Json growth_report(const Plan& plan, const Results& results) {
  Json series = Json::array();
  for (const Series& one : all_series(plan)) series.push_back(series_report(one, results));
  if (const auto threads = results.find("growth/threads"); threads != results.end())
    series.push_back(threads_report(threads->second));
  const auto features = results.find("growth/features");
  return {{"series", std::move(series)},
          {"features", features == results.end() ? Json::array() : features_report(features->second)}};
}

}  // namespace raylab::bench
