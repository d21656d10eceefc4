// Measures the policy of image comparison (docs/tolerance.md) on the checked-in references: every right renderer that could
// be built must pass with three times to spare, every known mistake must fail by a factor of two on a reference of its
// stage. Prints the page docs/calibration.md; exit code 1 if anything is nearer to the limit than that.
//   raylab-calibrate [quick]      quick: of each mistake, the first scene that shows it is enough

#include "bench/variants/handout_renderer.hpp"
#include "core/render/stages_engine.hpp"
#include "reference/engine/engine.hpp"
#include "tests/mistakes/evidence.hpp"
#include "tests/scores.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();

using namespace raylab;
using namespace raylab::test;
using namespace raylab::bench;

namespace {

constexpr double most_of_right = 1.0 / 3;

std::string text(double score) {
  if (std::isinf(score)) return "not finite";
  char digits[32];
  std::snprintf(digits, sizeof digits, score == 0 ? "0" : score < 10 ? "%.2f" : "%.0f", score);
  return digits;
}

// ---- Right renderers --------------------------------------------------------------------------------------------------

struct Right {
  std::string name;
  MakeEngine make;
};

std::vector<Right> right_renderers() {
  std::vector<Right> all{
      {"the solution",
       [](const Scene& s, const Settings& c) { return make_stages(s, c, import_tasks(*raylab_tasks_solution())); }},
      {"the engine in double", [](const Scene& s, const Settings& c) { return make_fast(s, c, {Precision::f64}); }},
      {"the engine in float", [](const Scene& s, const Settings& c) { return make_fast(s, c, {Precision::f32}); }}};
  const auto add = [&](const HandoutBuild& build, const std::string& name, const Variant& variant) {
    all.push_back({"handout, " + std::string(build.name) + ", " + name,
                   [build, variant](const Scene& s, const Settings& c) { return build.make(s, c, variant); }});
  };
  Variant plain, vectors, closed, shifted, middle, lifted, clamped;
  vectors.roots = Variant::Roots::half_b;
  vectors.glass = Variant::Glass::vectors;
  vectors.power_by_exp_log = true;
  closed.roots = Variant::Roots::geometric;
  closed.glass = Variant::Glass::closed;
  closed.lights_backwards = true;
  shifted.shadow_shift = 0.1;
  shifted.bounce_shift = 0.001;
  shifted.black_rim = true;
  middle.shadow_shift = 0.01;
  middle.bounce_shift = 0.0001;
  middle.roots = Variant::Roots::geometric;
  lifted.lift = 0.0005;
  clamped.clamp_each = true;
  clamped.shadow_shift = 0.05;
  const std::vector<std::pair<std::string, Variant>> variants{{"as printed", plain},
                                                              {"vector formulas", vectors},
                                                              {"closed formulas", closed},
                                                              {"shifts of 0.1 and 0.001, black rims", shifted},
                                                              {"shifts of 0.01 and 0.0001", middle},
                                                              {"lifted by 0.0005 along the normal", lifted},
                                                              {"each dot product clamped, shift of 0.05", clamped}};
  for (const HandoutBuild& build : handout_builds())
    for (const auto& [name, variant] : variants) {
      Variant single = variant;
      single.single_precision = true;
      add(build, name + ", double", variant);
      add(build, name + ", float", single);
    }
  return all;
}

// ---- The tables ---------------------------------------------------------------------------------------------------------

struct Row {
  std::string name;
  Scores worst;  ///< of a right renderer the greatest over all scenes, of a mistake those of the scene that shows it best
  std::string scene;
};

Row measure_right(const Right& right, const Subjects& subjects) {
  Row row{right.name, {}, "-"};
  for (const auto& [stage, list] : subjects)
    for (const Subject& subject : list) {
      const Scores scores = scores_of(subject, rendered(subject, right.make));
      if (std::max(scores.floats, scores.bytes) > std::max(row.worst.floats, row.worst.bytes)) row.scene = title(subject);
      row.worst.floats = std::max(row.worst.floats, scores.floats);
      row.worst.bytes = std::max(row.worst.bytes, scores.bytes);
    }
  return row;
}

bool print(const Row& row, bool holds) {
  std::cout << "| " << row.name << " | " << row.scene << " | " << text(row.worst.floats) << " | " << text(row.worst.bytes)
            << " |\n"
            << std::flush;
  if (!holds) std::cerr << "FAILED: " << row.name << " is too near to the limit\n";
  return holds;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string(argv[1]) == "quick";
  const Subjects subjects = subjects_by_stage();
  std::size_t passed = 0, failed = 0;
  const auto count = [&](bool holds) { ++(holds ? passed : failed); };

  std::cout
      << "# Calibration\n\n"
         "How far the limits of [the tolerance](tolerance.md) are from right renderers and from known mistakes, over all\n"
         "checked-in references but those of [the hard scenes](hard_scenes.md). A score of 1 is the limit.\n"
         "Made by `build/release/bin/raylab-calibrate >docs/calibration.md`.\n\n"
         "## Right renderers\n\n"
         "The greatest score over all references, and where; at most 1/3 is wanted.\n\n"
         "| renderer | nearest to the limit | floats | 8 bits |\n|---|---|---|---|\n";
  for (const Right& right : right_renderers()) {
    const Row row = measure_right(right, subjects);
    count(print(row, std::max(row.worst.floats, row.worst.bytes) <= most_of_right));
  }
  std::cout << "\n## Known mistakes\n\n"
               "The reference of the mistake's stage that shows it best, as floats and in 8 bits; at least 2 is wanted. "
               "Where that\n"
               "stage's pictures cannot show it, as a normal in flat colors, it is one of the next stage that can. "
               "[Known\nmistakes](mistakes.md) lists those, too, that only unit tests can find.\n\n"
               "| mistake | scene | floats | 8 bits |\n|---|---|---|---|\n";
  const StageTable right = import_tasks(*raylab_tasks_solution());
  for (const Mistake& mistake : known_mistakes()) {
    if (mistake.shows == Shows::in_unit_tests || mistake.shows == Shows::nowhere) continue;
    const Evidence best = best_evidence(mistake, right, subjects, quick);
    const Row row{std::string(mistake.task) + " " + std::string(mistake.name), best.scores, best.scene};
    count(print(row, counted(mistake, best.scores) >= least_of_wrong));
  }
  std::cerr << passed << " passed, " << failed << " failed\n";
  return failed == 0 ? 0 : 1;
}
