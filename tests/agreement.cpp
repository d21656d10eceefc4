// The three implementations, which share no equation, on every scene and every stage.

#include "core/render/render.hpp"
#include "core/render/stages_engine.hpp"
#include "core/scene/read_scene.hpp"
#include "reference/engine/engine.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

std::vector<std::filesystem::path> all_scenes() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data_folder("scenes")))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

struct Rendered {
  std::vector<Color> pixels;
  RayCounts rays;
};

Rendered run(const Engine& engine, ImageSize size) {
  Rendered rendered;
  const std::atomic<bool> never = false;
  const auto keep = [&](int, std::span<const Color> rows) {
    rendered.pixels.insert(rendered.pixels.end(), rows.begin(), rows.end());
  };
  rendered.rays = render(
                      engine, size, 2, keep, [](double) {}, never)
                      .rays;
  return rendered;
}

double largest_deviation(const std::vector<Color>& a, const std::vector<Color>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double here = deviation(a[k], b[k]);
    if (std::isnan(here)) return here;
    largest = std::max(largest, here);
  }
  return largest;
}

void check_counts(const RayCounts& counts, const RayCounts& expected) {
  CHECK(counts.primary == expected.primary);
  CHECK(counts.shadow == expected.shadow);
  CHECK(counts.reflected == expected.reflected);
  CHECK(counts.refracted == expected.refracted);
}

/// The size is odd, so that no row or column of pixels lies on a scene's own symmetry by chance of being even.
void check_stage(int stage) {
  const std::vector<std::filesystem::path> paths = all_scenes();
  REQUIRE(paths.size() >= 12);
  for (const auto& path : paths) {
    INFO(path);
    const SceneFile file = read_scene(path);
    REQUIRE(file.scene.has_value());
    const Settings settings{stage, {19, 14}, file.scene->max_bounces, {}};
    const Rendered truth = run(*make_oracle(*file.scene, settings), settings.size);
    const Rendered solution = run(*make_stages(*file.scene, settings, table()), settings.size);
    const Rendered fast = run(*make_fast(*file.scene, settings, Precision::f64), settings.size);
    const Rendered single = run(*make_fast(*file.scene, settings, Precision::f32), settings.size);
    // Rounding alone. Mirrors amplify it: in scene5 the worst pixels are 1.3e-12 (double) and 2e-3 (float) off.
    CHECK(largest_deviation(solution.pixels, truth.pixels) <= 1e-11);
    CHECK(largest_deviation(fast.pixels, truth.pixels) <= 1e-11);
    CHECK(largest_deviation(single.pixels, truth.pixels) <= 1e-2);
    check_counts(solution.rays, truth.rays);
    check_counts(fast.rays, truth.rays);
  }
}

}  // namespace

TEST_CASE("stage 1: solution, engine and oracle agree on every scene", "[stage1][agreement]") { check_stage(1); }
TEST_CASE("stage 2: solution, engine and oracle agree on every scene", "[stage2][agreement]") { check_stage(2); }
TEST_CASE("stage 3: solution, engine and oracle agree on every scene", "[stage3][agreement]") { check_stage(3); }
TEST_CASE("stage 4: solution, engine and oracle agree on every scene", "[stage4][agreement]") { check_stage(4); }
TEST_CASE("stage 5: solution, engine and oracle agree on every scene", "[stage5][agreement]") { check_stage(5); }
TEST_CASE("stage 6: solution, engine and oracle agree on every scene", "[stage6][agreement]") { check_stage(6); }
TEST_CASE("stage 7: solution, engine and oracle agree on every scene", "[stage7][agreement]") { check_stage(7); }
