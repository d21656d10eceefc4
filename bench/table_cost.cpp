// What the run-time table costs: the same driver and the same functions, called through the table's pointers and inlined.
//   raylab-bench-table SCENE.toml...
// Rounds alternate between the two, so that a machine that drifts slows both; the medians and their ratio are printed.

#include "bench/inlined_solution.hpp"
#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "core/scene/read_scene.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();

using namespace raylab;

namespace {

constexpr int rounds = 15;
constexpr Settings settings{6, {320, 240}, 5, AntiAliasing::none};

double seconds_of(const Engine& engine, std::vector<Color>& image) {
  const std::atomic<bool> never = false;
  image.clear();
  const auto start = std::chrono::steady_clock::now();
  render(
      engine, settings.size, 1,
      [&](int, std::span<const Color> rows) { image.insert(image.end(), rows.begin(), rows.end()); }, [](double) {}, never);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const StageTable table = import_tasks(*raylab_tasks_solution());
  std::printf("%-28s %10s %10s %7s   (stage 6, 320x240, 1 thread, %d rounds)\n", "scene", "table", "inlined", "ratio",
              rounds);
  bool all_equal = true;
  for (int k = 1; k < argc; ++k) {
    const SceneFile file = read_scene(argv[k]);
    if (!file.scene) return 1;
    const auto through_table = make_stages(*file.scene, settings, table);
    const auto inlined = make_inlined(*file.scene, settings);
    std::vector<double> table_seconds, inlined_seconds, ratios;
    std::vector<Color> table_image, inlined_image;
    for (int round = 0; round < rounds; ++round) {
      table_seconds.push_back(seconds_of(*through_table, table_image));
      inlined_seconds.push_back(seconds_of(*inlined, inlined_image));
      ratios.push_back(table_seconds.back() / inlined_seconds.back());
    }
    std::printf("%-28s %8.2fms %8.2fms %7.2f   images %s\n", argv[k], 1e3 * median(table_seconds),
                1e3 * median(inlined_seconds), median(ratios), table_image == inlined_image ? "equal" : "DIFFER");
    all_equal = all_equal && table_image == inlined_image;
  }
  return all_equal ? 0 : 1;
}
