#include "bench/report/bench.hpp"

#include "bench/report/compare.hpp"
#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/progress_bar.hpp"
#include "core/cli/watched_render.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"
#include "core/references/manifest.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;
using bench::Json;

struct Bench {
  std::vector<std::string> scenes;
  bool quick = false;
  std::string out = "out/bench";
  std::vector<std::string> compared;
};

/// Where nobody names scenes: the course's, and three of those that are hard for arithmetic.
std::vector<std::string> default_scenes(bool quick) {
  if (quick) return {"scene1", "scene3", "hard/giant_floor", "hard/far_spheres"};
  return {"scene1", "scene2", "scene3", "scene4", "scene5", "hard/giant_floor", "hard/far_spheres", "hard/huge_coordinates"};
}

/// A scene's file: as it is named, or by the name of one of raylab's own scenes.
fs::path scene_file(const std::string& name) {
  if (fs::exists(name)) return name;
  const fs::path own = data_folder("scenes") / (name + ".toml");
  if (fs::exists(own)) return own;
  throw Failure(name + ": there is no such file, nor a scene of this name in " + data_folder("scenes").string(),
                wrong_usage);
}

bench::BenchRun prepare(const Bench& bench) {
  bench::BenchRun run;
  run.plan = {bench.quick, thread_count(0)};
  run.out = bench.out;
  run.command = "raylab bench";
  for (const std::string& scene : bench.scenes) run.command += " " + scene;
  run.command += (bench.quick ? " --quick --out " : " --out ") + bench.out;
  for (const std::string& name : bench.scenes.empty() ? default_scenes(bench.quick) : bench.scenes) {
    const fs::path file = scene_file(name);
    const fs::path in_scenes = fs::relative(file, data_folder("scenes"));
    const bool own = !in_scenes.empty() && *in_scenes.begin() != "..";
    const std::string shown = own ? in_scenes.parent_path() / in_scenes.stem() : file.stem();
    if (std::any_of(run.scenes.begin(), run.scenes.end(), [&](const auto& scene) { return scene.name == shown; }))
      throw Failure(name + ": a scene of this name is there twice", wrong_usage);
    run.scenes.push_back({shown, own && is_hard("scenes" / in_scenes), load_scene(file)});
    run.scene_hashes.push_back(file_hash(file));
  }
  return run;
}

void print_choices(const Json& report) {
  for (const Json& choice : report["choices"]) {
    if (choice["pick"].is_null()) continue;
    std::cout << "For " << choice["need"].get<std::string>() << ": " << choice["pick"].get<std::string>() << '\n'
              << "  " << choice["sentence"].get<std::string>() << '\n';
    if (!choice["hard_sentence"].is_null()) std::cout << "  " << choice["hard_sentence"].get<std::string>() << '\n';
  }
  std::cout << report["noise"]["sentence"].get<std::string>() << '\n';
}

void measure(const Bench& bench) {
  const bench::BenchRun run = prepare(bench);
  Json report;
  {
    ProgressBar bar("bench");
    const auto progress = [&](double done, const std::string& unit) { bar.show(done, unit); };
    try {
      report = run_bench(run, solution_table(), progress, interrupt_flag());
    } catch (const Cancelled&) {
      throw Failure("interrupted: what was measured is in " + (run.out / "measurements.jsonl").string() +
                        ", and the same command goes on from there",
                    interrupted);
    }
  }
  print_choices(report);
  std::cout << (run.out / "report.html").string() << '\n';
}

Json read_report(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Failure(path + ": cannot be read", wrong_usage);
  try {
    return Json::parse(in);
  } catch (const Json::exception&) {
    throw Failure(path + ": not JSON: name the report.json of a run of raylab bench", wrong_usage);
  }
}

std::string times_of(const bench::Change& change) {
  char text[32];
  std::snprintf(text, sizeof text, "%9.3g x  ", change.ratio);
  return text;
}

void print_changes(const char* title, const std::vector<bench::Change>& changes) {
  if (changes.empty()) return;
  std::cout << '\n' << title << '\n';
  constexpr std::size_t most = 30;
  for (std::size_t k = 0; k < std::min(most, changes.size()); ++k) {
    const bench::Change& change = changes[k];
    char values[64];
    std::snprintf(values, sizeof values, "%.4g -> %.4g ", change.before.value, change.after.value);
    std::cout << "  " << (change.better ? "better " : "worse  ") << times_of(change) << change.after.section << ": "
              << change.after.subject << ": " << change.after.variant << ": " << change.after.what << ' ' << values
              << change.after.unit << '\n';
  }
  if (changes.size() > most) std::cout << "  ... and " << changes.size() - most << " that changed less\n";
}

void print_only(const char* title, const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::cout << '\n' << title << '\n';
  for (const std::string& name : names) std::cout << "  " << name << '\n';
}

void compare(const std::string& before, const std::string& after) {
  bench::ReportChanges changes;
  try {
    changes = bench::compare_reports(read_report(before), read_report(after));
  } catch (const bench::NoReport& error) {
    throw Failure(error.what(), wrong_usage);
  } catch (const Json::exception& error) {
    throw Failure(std::string("one of the two is not a whole report of raylab bench: ") + error.what(), wrong_usage);
  }
  if (changes.times + changes.errors == 0) throw Failure("the two reports have no figure in common");
  for (const std::string& sentence : changes.runs_differ) std::cout << "The runs differ in " << sentence << '\n';
  std::printf("%zu times: the second run takes %.3g times as long in the median; ", changes.times, changes.timing_ratio);
  if (changes.too_noisy)
    std::printf("in one of the runs the machine was too busy to compare single ones.\n");
  else
    std::printf("%zu changed beyond noise.\n", changes.changed_times.size());
  std::printf("%zu errors and counts: %zu changed.\n", changes.errors, changes.changed_errors.size());
  print_changes("Times", changes.changed_times);
  print_changes("Errors and counts", changes.changed_errors);
  print_only("Only in the first", changes.only_before);
  print_only("Only in the second", changes.only_after);
}

}  // namespace

void add_bench(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bench", "Measure speed against error on this machine: a page, JSON and CSV");
  const auto bench = std::make_shared<Bench>();
  CLI::Option* scenes =
      command->add_option("SCENE", bench->scenes,
                          "Scene files, or names (scene3, hard/giant_floor); default: scene1 to scene5 and three hard ones");
  CLI::Option* quick =
      command->add_flag("--quick", bench->quick, "Less of everything: under a minute, not a quarter of an hour");
  CLI::Option* out = command->add_option("--out", bench->out, "The folder for report.html, report.json and report.csv")
                         ->type_name("DIR")
                         ->capture_default_str();
  command->add_option("--compare", bench->compared, "What differs between two report.json by more than noise")
      ->expected(2)
      ->type_name("A.json B.json")
      ->excludes(scenes)
      ->excludes(quick)
      ->excludes(out);
  command->footer(
      "Times are medians of rounds in which all variants take turns. An interrupted run goes on where it was, with the "
      "same\n"
      "command. docs/bench.md explains the report.\n\n"
      "Examples:\n"
      "  raylab bench --quick                          a first look, out/bench/report.html\n"
      "  raylab bench --out before                     everything\n"
      "  raylab bench my.toml --out mine               on a scene of your own\n"
      "  raylab bench --compare before/report.json after/report.json");
  command->callback([bench] {
    if (bench->compared.empty())
      measure(*bench);
    else
      compare(bench->compared[0], bench->compared[1]);
  });
}

}  // namespace raylab::cli
