// Is a report of `raylab bench` complete, and is every error in it where it should be? Says nothing of times: they belong to
// the machine.
//   raylab-bench-check FOLDER

#include "bench/report/figures.hpp"
#include "core/render/stage_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace raylab;
using bench::Json;

namespace {

int passed = 0, failed = 0;

void check(bool holds, const std::string& what) {
  ++(holds ? passed : failed);
  if (!holds) std::printf("FAILED: %s\n", what.c_str());
}

constexpr double most_in_double = 1e-9;                 // of a component, wherever no decision has flipped
const double most_in_float = std::pow(10, -65 / 20.0);  // 65 decibels

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// ---- Whole images ---------------------------------------------------------------------------------------------------

bool few_flipped(const Json& error) {
  return error["flipped"].get<double>() <= std::max(1.0, 1e-3 * error["pixels"].get<double>());
}

bool own_formulas(const Json& variant) {
  return variant["renderer"] == "stages" || (variant["sphere"] == "foot" && variant["power"] == "log1p");
}

void check_variant(const Json& scene, const Json& variant) {
  const std::string where = scene["scene"].get<std::string>() + ": " + variant["id"].get<std::string>();
  const Json& error = variant["arithmetic"];
  check(variant["mpixels_per_second"]["median"] > 0, where + ": a speed");
  check(error["pixels"] > 0, where + ": compared with the oracle");
  if (!own_formulas(variant)) return;
  check(error["non_finite"] == 0, where + ": every pixel is finite");
  if (variant["precision"] == "f64") {
    check(error["max_rest"] <= most_in_double, where + ": right to 1e-9");
    check(few_flipped(error), where + ": hardly a decision flipped");
  } else if (!scene["hard"]) {
    check(error["rmse_rest"] <= most_in_float, where + ": 65 dB");
    check(few_flipped(error), where + ": hardly a decision flipped");
  }
}

std::size_t variants_with(const Json& scene, const char* field, const Json& value) {
  return static_cast<std::size_t>(std::count_if(scene["variants"].begin(), scene["variants"].end(),
                                                [&](const Json& variant) { return variant[field] == value; }));
}

double rmse_of_pattern(const Json& scene, const char* aa) {
  for (const Json& pattern : scene["sampling"])
    if (pattern["aa"] == aa) return pattern["error"]["rmse"];
  return std::nan("");
}

void check_scene(const Json& scene, const Json& simd) {
  const std::string name = scene["scene"];
  check(scene["same_bits"] == true, name + ": the same bits with every instruction set");
  check(scene["oracle_mpixels_per_second"] > 0, name + ": the oracle's speed");
  for (const Json& target : simd) check(variants_with(scene, "simd", target) >= 6, name + ": with " + target.dump());
  for (const char* const renderer : {"fast", "stages", "textbook"})
    check(variants_with(scene, "renderer", renderer) >= 3, name + ": by " + renderer);
  for (const char* const aa : {"none", "rotated4", "adaptive"})
    check(variants_with(scene, "aa", aa) == scene["variants"].size() / 3, name + ": all with " + aa);
  for (const Json& variant : scene["variants"]) check_variant(scene, variant);

  check(scene["sampling"].size() == 6, name + ": six patterns");
  check(rmse_of_pattern(scene, "rotated4") < 0.7 * rmse_of_pattern(scene, "none"), name + ": four samples beat one");
  check(rmse_of_pattern(scene, "grid64") < rmse_of_pattern(scene, "grid16"), name + ": 64 samples beat 16");
  check(scene["model"].size() == 6, name + ": six accepted variants");
  if (!scene["hard"])
    check(scene["model"][0]["error"]["rmse_judged"] <= most_in_double, name + ": the textbook's renderer is right");
}

/// What the hard scenes are for: a textbook's formulas are visibly wrong on them, in float at least.
void check_hard_scene(const Json& scene) {
  for (const Json& variant : scene["variants"])
    if (variant["renderer"] == "textbook" && variant["precision"] == "f32")
      check(variant["arithmetic"]["flipped"].get<double>() > 0.03 * variant["arithmetic"]["pixels"].get<double>(),
            scene["scene"].get<std::string>() + ": the textbook's formulas are wrong in float");
}

// ---- Single tasks ---------------------------------------------------------------------------------------------------

/// The greatest found is 27: of a half vector between l and v that are unit only to a rounding.
constexpr double most_unexplained = 32;

void check_result(const std::string& where, const Json& result) {
  check(result["ns"]["median"] > 0, where + ": a time");
  check(result["answers"] > 0, where + ": compared with the oracle");
  if (result["by"] == "textbook") return;
  check(result["non_finite"] == 0, where + ": every answer is finite");
  check(result["unexplained"].is_null() || result["unexplained"] <= most_unexplained, where + ": right but for rounding");
  if (result["precision"] == "f64") check(result["wrong_decisions"] == 0, where + ": no wrong decision");
}

void check_kernels(const Json& kernels) {
  check(kernels.size() == task_list().size(), "all tasks");
  std::size_t hard = 0;
  for (const Json& task : kernels) {
    check(task["families"][0]["family"] == "ordinary", task["name"].dump() + ": ordinary inputs");
    for (const Json& family : task["families"]) {
      hard += family["hard"] == true;
      const std::string where = task["name"].get<std::string>() + ", " + family["family"].get<std::string>();
      check(family["results"].size() == 5, where + ": by five");
      for (const Json& result : family["results"]) check_result(where + ", " + result["by"].get<std::string>(), result);
    }
  }
  check(hard > 30, "families of hard inputs");
}

// ---- The rest -------------------------------------------------------------------------------------------------------

void check_growth(const Json& growth) {
  for (const char* const id : {"spheres", "lights", "bounces", "pixels", "threads"})
    check(std::any_of(growth["series"].begin(), growth["series"].end(),
                      [&](const Json& series) { return series["id"] == id && !series["curves"].empty(); }),
          std::string("growth over ") + id);
  for (const Json& series : growth["series"])
    for (const Json& curve : series["curves"]) check(!curve["points"].empty(), "points of " + series["id"].dump());
  check(growth["features"].size() >= 8, "features with and without");
}

double rmse_at(const Json& pattern, double degrees) {
  double found = std::nan("");
  for (const Json& point : pattern["points"])
    if (std::abs(point["degrees"].get<double>() - degrees) < 0.01) found = point["rmse"];
  return found;
}

void check_edges(const Json& edges) {
  check(edges["patterns"].size() == 6, "edges by six patterns");
  const Json &grid = edges["patterns"][1], &rotated = edges["patterns"][2];
  const double along = rmse_at(rotated, 0) / rmse_at(grid, 0), askew = rmse_at(rotated, 26.565) / rmse_at(grid, 26.565);
  check(along > 0.4 && along < 0.65, "the rotated grid halves the error of edges along the rows");
  check(askew > 1.6 && askew < 2.6, "and doubles it near 26 degrees");
}

void check_report(const Json& report, const std::filesystem::path& folder) {
  for (const char* const field :
       {"date", "command", "mode", "version", "compiler", "flags", "cores", "simd", "fma_peak_gflops"})
    check(!report["header"][field].is_null(), std::string("the header's ") + field);
  check(report["choices"].size() == 4, "four choices");
  for (const Json& choice : report["choices"]) check(choice["pick"].is_string(), choice["need"].dump() + ": a pick");
  check(!report["images"]["scenes"].empty(), "scenes");
  for (const Json& scene : report["images"]["scenes"]) {
    check_scene(scene, report["header"]["simd"]);
    if (scene["hard"]) check_hard_scene(scene);
  }
  check_kernels(report["kernels"]);
  check_growth(report["growth"]);
  check_edges(report["edges"]);
  check(report["noise"]["sentence"].is_string(), "a word on noise");
  const std::string csv = text_of(folder / "report.csv");
  check(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == bench::figures_of(report).size() + 1,
        "report.csv has every figure");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: raylab-bench-check FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    check_report(Json::parse(text_of(folder / "report.json")), folder);
  } catch (const Json::exception& error) {
    check(false, std::string("report.json: ") + error.what());
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
