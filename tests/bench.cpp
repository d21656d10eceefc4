// What `raylab bench` makes of its measurements. The measuring itself is tried by tests/bench_test.sh.

#include "bench/report/choices.hpp"
#include "bench/report/compare.hpp"
#include "bench/report/edges.hpp"
#include "bench/report/figures.hpp"
#include "bench/report/image_errors.hpp"
#include "bench/report/journal.hpp"
#include "bench/report/race.hpp"
#include "core/render/engine.hpp"
#include "tests/support.hpp"
#include "tests/temporary_folder.hpp"

#include <sstream>

using namespace raylab;
using namespace raylab::bench;
using namespace raylab::test;

namespace {

const std::atomic<bool> never = false;

/// A report of one scene and one variant, with some figures of each kind.
Json small_report() {
  const Json error = {{"rmse", 1e-7},    {"max", 2e-7},       {"psnr", 140.0},    {"flipped", 0},       {"non_finite", 0},
                      {"pixels", 10000}, {"rmse_rest", 1e-7}, {"max_rest", 2e-7}, {"rmse_judged", 1e-7}};
  const Json speed = {{"median", 40.0}, {"low", 39.0}, {"high", 41.0}, {"rounds", 7}, {"noisy", false}};
  const Json variant = {{"id", "avx2 fast f32 none"},
                        {"renderer", "fast"},
                        {"precision", "f32"},
                        {"simd", "avx2"},
                        {"sphere", "foot"},
                        {"power", "log1p"},
                        {"aa", "none"},
                        {"samples", 1.0},
                        {"mpixels_per_second", speed},
                        {"arithmetic", error},
                        {"on_front", true}};
  const Json scene = {{"scene", "scene1"},
                      {"hard", false},
                      {"same_bits", true},
                      {"oracle_mpixels_per_second", 0.01},
                      {"variants", Json::array({variant})},
                      {"sampling", Json::array()},
                      {"model", Json::array()}};
  return {{"format", "raylab bench 1"},
          {"header", {{"mode", "quick"}, {"processor", "one"}}},
          {"images", {{"scenes", Json::array({scene})}}}};
}

Json& only_variant(Json& report) { return report["images"]["scenes"][0]["variants"][0]; }

}  // namespace

TEST_CASE("bench: a spread is the median and the quartiles", "[bench]") {
  const Json five = spread({5, 1, 2, 4, 3});
  CHECK(five["median"] == 3.0);
  CHECK(five["low"] == 2.0);
  CHECK(five["high"] == 4.0);
  CHECK(five["noisy"] == true);
  const Json calm = spread({100, 101, 99, 100.5, 99.5, 180});  // one disturbance of six does not count
  CHECK(calm["noisy"] == false);
  const Json few = spread({1, 3});
  CHECK(few["low"] == 1.0);
  CHECK(few["high"] == 3.0);
}

TEST_CASE("bench: contenders take turns, each as often", "[bench]") {
  std::string order;
  const std::vector<std::function<void()>> contenders{[&] { order += 'a'; }, [&] { order += 'b'; }, [&] { order += 'c'; }};
  const auto seconds = race(contenders, 3, 0, never);
  CHECK(order ==
        "abc"
        "abc"
        "bca"
        "cab");  // once to find out how long it takes, then the rounds
  CHECK(seconds.size() == 3);
  for (const auto& rounds : seconds) CHECK(rounds.size() == 3);
}

TEST_CASE("bench: a contender too fast for the clock runs many times", "[bench]") {
  int runs = 0;
  double now = 0;
  static double* clock = nullptr;
  clock = &now;
  const auto seconds = race(std::vector<std::function<void()>>{[&] {
                              ++runs;
                              now += 0.25;
                            }},
                            2, 1, never, [] { return *clock; });
  CHECK(runs == (1 + 2 + 4) + 2 * 4);
  CHECK(seconds[0] == std::vector<double>{0.25, 0.25});
}

TEST_CASE("bench: whoever takes long takes part in three rounds only", "[bench]") {
  static double now = 0;
  const std::vector<std::function<void()>> contenders{[] { now += 0.4; }, [] { now += 0.01; }};
  const auto seconds = race(contenders, 9, 0, never, [] { return now; });
  CHECK(seconds[0].size() == 3);
  CHECK(seconds[1].size() == 9);
}

TEST_CASE("bench: a race ends when it is to stop", "[bench]") {
  std::atomic<bool> stop = false;
  int runs = 0;
  const std::vector<std::function<void()>> contenders{[&] { stop = ++runs == 2; }};
  CHECK_THROWS_AS(race(contenders, 100, 0, stop), Cancelled);
  CHECK(runs == 2);
}

TEST_CASE("bench: errors of an image, with and without what is flipped", "[bench]") {
  Image right(2, 2, Color(0.5));
  Image image = right;
  image.pixels[0] = Color(0.5, 0.5, 0.5 + 3e-3);
  image.pixels[1] = Color(0.9, 0.5, 0.5);  // beyond 2/255
  const Json error = image_error(image, right);
  CHECK(error["pixels"] == 4);
  CHECK(error["flipped"] == 1);
  CHECK(error["non_finite"] == 0);
  CHECK(error["max"].get<double>() == within(1e-15, 0.4));
  CHECK(error["max_rest"].get<double>() == within(1e-15, 3e-3));
  CHECK(error["rmse"].get<double>() == within(1e-15, std::sqrt((0.16 + 9e-6) / 12)));
  CHECK(error["rmse_rest"].get<double>() == within(1e-15, std::sqrt(9e-6 / 9)));
  CHECK(error["psnr"].get<double>() == within(1e-12, -20 * std::log10(error["rmse"].get<double>())));
  CHECK(error["rmse_judged"] == error["rmse"]);  // one in four is more than a few
}

TEST_CASE("bench: what is no number is counted, and what the oracle does not know is left out", "[bench]") {
  Image right(2, 1, Color(0.5));
  Image image = right;
  image.pixels[0].g = std::numeric_limits<double>::quiet_NaN();
  Json error = image_error(image, right);
  CHECK(error["non_finite"] == 1);
  CHECK(error["pixels"] == 2);
  CHECK(error["rmse"] == 0.0);
  CHECK(error["psnr"].is_null());
  right.pixels[0] = Color(std::numeric_limits<double>::quiet_NaN());
  error = image_error(image, right);
  CHECK(error["non_finite"] == 0);
  CHECK(error["pixels"] == 1);
}

TEST_CASE("bench: edges have the errors that can be worked out", "[bench]") {
  const Plan plan{.quick = true};
  Results results;
  for (const Unit& unit : edge_units(plan)) results[unit.name] = unit.measure(never);
  const Json report = edge_report(results);
  const auto rmse = [&](const char* aa, double degrees) -> double {
    for (const Json& pattern : report["patterns"])
      if (pattern["aa"] == aa)
        for (const Json& point : pattern["points"])
          if (std::abs(point["degrees"].get<double>() - degrees) < 0.01) return point["rmse"];
    return -1;
  };
  // n rows of samples know an edge along the rows to 1/n, evenly: an error of 1/(n sqrt(12)).
  CHECK(rmse("none", 0) == within(0.02, 1 / std::sqrt(12)));
  CHECK(rmse("grid4", 0) == within(0.01, 0.5 / std::sqrt(12)));
  CHECK(rmse("rotated4", 0) == within(0.005, 0.25 / std::sqrt(12)));
  CHECK(rmse("grid64", 0) == within(0.005, 0.125 / std::sqrt(12)));
  CHECK(rmse("rotated4", 90) == within(0.005, 0.25 / std::sqrt(12)));
  // Along the rotated grid's own rows there are but two of them.
  CHECK(rmse("rotated4", 26.565) > 1.7 * rmse("rotated4", 0));
  CHECK(rmse("rotated4", 26.565) > 1.7 * rmse("grid4", 26.565));
  CHECK(report["sentence"].get<std::string>().find("26.6 degrees") != std::string::npos);
}

TEST_CASE("bench: a journal keeps what was measured, but for a line that was cut off", "[bench]") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "run/measurements.jsonl";
  const Json identity = {{"mode", "quick"}};
  {
    Journal journal(path, identity);
    journal.add("one", {1, 2}, 0.5);
    journal.add("two", {{"x", 0.1}}, 0.25);
  }
  std::ofstream(path, std::ios::app) << "{\"unit\":\"three\",\"sec";
  {
    Journal journal(path, identity);
    CHECK(journal.results().size() == 2);
    CHECK(journal.results().at("two")["x"] == 0.1);
    CHECK(journal.seconds() == 0.75);
    journal.add("three", 3, 1);
  }
  Journal journal(path, identity);
  CHECK(journal.results().size() == 3);
  CHECK_THROWS_WITH(Journal(path, {{"mode", "full"}}), ContainsSubstring("differs from this one in: mode."));
  journal.remove();
  CHECK(!std::filesystem::exists(path));
}

TEST_CASE("bench: what is no journal is left alone", "[bench]") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write("measurements.jsonl", "shopping list\n");
  CHECK_THROWS_WITH(Journal(path, Json::object()), ContainsSubstring("is no journal"));
  CHECK(std::filesystem::file_size(path) == 14);
}

TEST_CASE("bench: figures become CSV that a spreadsheet reads", "[bench]") {
  std::ostringstream out;
  write_csv(out,
            {{.section = "kernels",
              .subject = "2.2 sphere_hit, far \"tiny\"",
              .variant = "fast f32",
              .what = "time",
              .unit = "ns",
              .value = 1.5,
              .low = 1.25,
              .high = 2.0,
              .noisy = true},
             {.section = "edges", .subject = "0.0 degrees", .variant = "none", .what = "rmse", .unit = "", .value = 1e-7}});
  CHECK(out.str() ==
        "section,subject,variant,what,unit,value,low,high,noisy\r\n"
        "kernels,\"2.2 sphere_hit, far \"\"tiny\"\"\",fast f32,time,ns,1.5,1.25,2.0,noisy\r\n"
        "edges,0.0 degrees,none,rmse,,1e-07,,,\r\n");
}

TEST_CASE("bench: every figure of a report is in its list", "[bench]") {
  const std::vector<Figure> figures = figures_of(small_report());
  CHECK(figures.size() == 1 + 1 + 8);  // the oracle's speed; the variant's, and its errors
  CHECK(figures[1].what == "speed");
  CHECK(figures[1].low == 39.0);
  CHECK(figures[1].more_is_better);
}

TEST_CASE("bench: a report has not changed from itself", "[bench]") {
  const ReportChanges changes = compare_reports(small_report(), small_report());
  CHECK(changes.times == 1);
  CHECK(changes.errors == 9);
  CHECK(changes.changed_times.empty());
  CHECK(changes.changed_errors.empty());
  CHECK(changes.runs_differ.empty());
  CHECK(changes.timing_ratio == 1);
}

TEST_CASE("bench: a time changes where noise cannot have done it", "[bench]") {
  Json after = small_report();
  const auto with_speed = [&](double median, double spread) {
    only_variant(after)["mpixels_per_second"] = {
        {"median", median}, {"low", median - spread}, {"high", median + spread}, {"noisy", false}};
    return compare_reports(small_report(), after);
  };
  CHECK(with_speed(30, 0.5).changed_times.size() == 1);
  CHECK(with_speed(30, 6).changed_times.empty());      // too noisy
  CHECK(with_speed(38.5, 0.1).changed_times.empty());  // under 5 %
  const ReportChanges changes = with_speed(20, 0.1);
  REQUIRE(changes.changed_times.size() == 1);
  CHECK(!changes.changed_times[0].better);
  CHECK(changes.timing_ratio == 2);
}

TEST_CASE("bench: an error changes where it differs at all", "[bench]") {
  Json after = small_report();
  only_variant(after)["arithmetic"]["flipped"] = 3;
  only_variant(after)["arithmetic"]["psnr"] = 150.0;
  const ReportChanges changes = compare_reports(small_report(), after);
  REQUIRE(changes.changed_errors.size() == 2);
  CHECK(changes.changed_errors[0].after.what == "arithmetic flipped");  // from nothing: the greatest
  CHECK(!changes.changed_errors[0].better);
  CHECK(changes.changed_errors[1].better);
}

TEST_CASE("bench: reports of other runs are told apart", "[bench]") {
  Json after = small_report();
  after["header"]["processor"] = "two";
  only_variant(after)["id"] = "sse4 fast f32 none";
  const ReportChanges changes = compare_reports(small_report(), after);
  CHECK(changes.runs_differ == std::vector<std::string>{"processor: \"one\", then \"two\""});
  CHECK(changes.only_before == std::vector<std::string>{"images: scene1: avx2 fast f32 none"});
  CHECK(changes.only_after == std::vector<std::string>{"images: scene1: sse4 fast f32 none"});
  CHECK_THROWS_WITH(compare_reports(small_report(), {{"format", "else"}}), ContainsSubstring("not a report"));
}

TEST_CASE("bench: times of a busy machine are not compared", "[bench]") {
  Json after = small_report();
  only_variant(after)["mpixels_per_second"] = {{"median", 4.0}, {"low", 3.9}, {"high", 4.1}, {"noisy", false}};
  after["noise"] = {{"noisy", 10}, {"times", 100}};
  CHECK(compare_reports(small_report(), after).changed_times.size() == 1);
  after["noise"]["noisy"] = 11;
  const ReportChanges changes = compare_reports(small_report(), after);
  CHECK(changes.too_noisy);
  CHECK(changes.changed_times.empty());
  CHECK(changes.timing_ratio == 10);
}

TEST_CASE("bench: scenes that have changed are named", "[bench]") {
  Json before = small_report(), after = small_report();
  before["header"]["scenes"] = after["header"]["scenes"] = Json::array({{{"scene", "scene1"}, {"sha1", "a"}}});
  CHECK(compare_reports(before, after).runs_differ.empty());
  after["header"]["scenes"][0]["sha1"] = "b";
  after["images"]["scenes"][0]["error_size"] = {32, 24};
  CHECK(compare_reports(before, after).runs_differ ==
        std::vector<std::string>{"the sha1 of scene1", "the error_size of scene1"});
}

TEST_CASE("bench: the fastest that keeps the bound is picked", "[bench]") {
  Json report = small_report();
  Json& variants = report["images"]["scenes"][0]["variants"];
  const auto add = [&](const char* id, const char* precision, double speed, double error, const char* sphere = "foot") {
    Json one = variants[0];
    one["id"] = id;
    one["simd"] = std::string(id).substr(0, std::string(id).find(' '));
    one["precision"] = precision;
    one["sphere"] = sphere;
    one["mpixels_per_second"]["median"] = speed;
    one["arithmetic"]["max_rest"] = error;
    variants.push_back(one);
  };
  add("avx2 fast f64 none", "f64", 20, 1e-14);
  add("avx512 fast f64 none", "f64", 25, 1e-14);
  add("avx512 fast f32 textbook-sphere none", "f32", 60, 1e-6, "textbook");  // nobody can ask for it
  const Json choices = choices_from(report["images"]);
  CHECK(choices[0]["pick"] == "--engine fast --precision f32");
  CHECK(choices[0]["sentence"].get<std::string>().ends_with("1.6 times as fast as --engine fast --precision f64."));
  CHECK(choices[1]["pick"] == "--engine fast --precision f64");
  CHECK(choices[1]["sentence"].get<std::string>().find("avx512") != std::string::npos);

  variants[0]["arithmetic"]["flipped"] = 11;  // of 10000
  CHECK(choices_from(report["images"])[0]["pick"] == "--engine fast --precision f64");
  Json other = report["images"]["scenes"][0];
  other["scene"] = "scene2";
  other["variants"].erase(1);
  report["images"]["scenes"].push_back(other);
  CHECK(choices_from(report["images"])[1]["sentence"].get<std::string>().find("avx512") != std::string::npos);
  other["variants"].erase(1);
  report["images"]["scenes"][1] = other;  // no f64 there
  CHECK(choices_from(report["images"])[1]["pick"].is_null());
  report["images"]["scenes"].erase(1);
  report["images"]["scenes"][0]["hard"] = true;  // all that there is
  CHECK(choices_from(report["images"])[1]["pick"] == "--engine fast --precision f64");
  for (Json& one : report["images"]["scenes"][0]["variants"]) one["arithmetic"]["non_finite"] = 1;
  CHECK(choices_from(report["images"])[0]["pick"].is_null());
}
