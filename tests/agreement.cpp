// The three implementations, which share no equation, on every scene and every stage.

#include "core/image/data_folder.hpp"
#include "core/references/manifest.hpp"
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

enum class Which { hard, others };  // the scenes of scenes/hard, or all but those

std::vector<std::filesystem::path> all_scenes(Which which) {
  const std::filesystem::path scenes = data_folder("scenes");
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes)) {
    const bool hard = is_hard(entry.path().lexically_relative(scenes.parent_path()));
    if (entry.path().extension() == ".toml" && hard == (which == Which::hard)) paths.push_back(entry.path());
  }
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

bool hangs_on_decision(const PixelWord& word) { return word.margin <= 1e-9; }

/// The largest deviation in units of what rounding may do: 1e-12 and eight times what it does to the pixel's rays, on every
/// pixel that hangs on no decision. Mirrors amplify: no one number fits all pixels.
double largest_deviation(const std::vector<Color>& pixels, const std::vector<PixelWord>& truth) {
  REQUIRE(pixels.size() == truth.size());
  double largest = 0;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    if (hangs_on_decision(truth[k])) continue;
    const double here = deviation(pixels[k], truth[k].together.value) / (1e-12 + 8 * truth[k].sensitivity);
    if (std::isnan(here)) return here;
    largest = std::max(largest, here);
  }
  return largest;
}

/// Pixels left out above must be few, but where a scene is made of them, and none undecided by the oracle.
void check_word(const std::vector<PixelWord>& truth, const std::string& scene) {
  CHECK(std::all_of(truth.begin(), truth.end(), [](const PixelWord& word) { return is_finite(word.together.value); }));
  // A lamp that lies in the ceiling: t = distance in every pixel of the floor. A sun on the horizon: the shadow rays of all
  // balls are nearly parallel to the floor.
  if (scene == "ceiling_lamp" || scene == "grazing_light") return;
  const auto left_out = std::count_if(truth.begin(), truth.end(), hangs_on_decision);
  CHECK(left_out <= static_cast<std::ptrdiff_t>(truth.size() / 50));
}

void check_counts(const RayCounts& counts, const RayCounts& expected) {
  CHECK(counts.primary == expected.primary);
  CHECK(counts.shadow == expected.shadow);
  CHECK(counts.reflected == expected.reflected);
  CHECK(counts.refracted == expected.refracted);
}

/// Solution and engine against the oracle. No row of pixels looks along a level camera's axis, where planes are parallel to
/// it: the height is even.
std::vector<PixelWord> check_agreement(const Scene& scene, int stage) {
  const Settings settings{stage, {13, 10}, scene.max_bounces, {}};
  std::vector<PixelWord> truth(13 * 10);
  const Rendered oracle = run(*make_witness(scene, settings, truth, 1), settings.size);
  const Rendered solution = run(*make_stages(scene, settings, table()), settings.size);
  const Rendered fast = run(*make_fast(scene, settings, {Precision::f64}), settings.size);
  CHECK(largest_deviation(solution.pixels, truth) <= 1);
  CHECK(largest_deviation(fast.pixels, truth) <= 1);
  check_counts(solution.rays, oracle.rays);
  check_counts(fast.rays, oracle.rays);
  return truth;
}

void check_stage(int stage, Which which = Which::others) {
  const std::vector<std::filesystem::path> paths = all_scenes(which);
  REQUIRE(paths.size() >= 9);
  for (const auto& path : paths) {
    INFO(path);
    const SceneFile file = read_scene(path);
    REQUIRE(file.scene.has_value());
    check_word(check_agreement(*file.scene, stage), path.stem().string());
  }
}

/// A ball above a floor and one below, lit from above or below. A ball of glass is half sunk into the floor, if it is to be:
/// through it the camera sees the other side.
Scene floor_between(bool glass, double camera_height, double light_height) {
  Scene scene;
  scene.max_bounces = 3;
  scene.camera = {{0.3, camera_height, 6}, {-0.05, -camera_height / 6, -1}, {0, 1, 0}, 30};
  scene.planes = {{{{0, 0, 0}, {0, 1, 0}}, {{0.7, 0.7, 0.6}, 0, false, 1.5}}};
  scene.spheres = {{{{-1.3, 1, 0}, 0.8}, {{0.9, 0.3, 0.2}, 200, false, 1.5}},
                   {{{0.6, -1.2, -1}, 0.7}, {{0.2, 0.4, 0.9}, 0, false, 1.5}}};
  if (glass) scene.spheres.push_back({{{1, 0, 1}, 1.2}, {{1, 1, 1}, 0, true, 1.5}});
  scene.point_lights = {{{2, light_height, 3}, 20}};
  scene.directional_lights = {{{-0.2, -light_height, -0.3}, 0.4}};
  scene.ambient_lights = {{0.1}};
  return scene;
}

}  // namespace

TEST_CASE("solution, engine and oracle agree on what is seen and lit from either side of a plane", "[agreement]") {
  for (const bool glass : {false, true})
    for (const double camera_height : {1.5, -1.5})
      for (const double light_height : {4., -4.})
        for (const int stage : {4, 6}) {
          INFO((glass ? "glass, " : "") << "camera at " << camera_height << ", light at " << light_height << ", stage "
                                        << stage);
          check_agreement(floor_between(glass, camera_height, light_height), stage);
        }
}

TEST_CASE("stage 1: solution, engine and oracle agree on every scene", "[stage1][agreement]") { check_stage(1); }
TEST_CASE("stage 2: solution, engine and oracle agree on every scene", "[stage2][agreement]") { check_stage(2); }
TEST_CASE("stage 3: solution, engine and oracle agree on every scene", "[stage3][agreement]") { check_stage(3); }
TEST_CASE("stage 4: solution, engine and oracle agree on every scene", "[stage4][agreement]") { check_stage(4); }
TEST_CASE("stage 5: solution, engine and oracle agree on every scene", "[stage5][agreement]") { check_stage(5); }
TEST_CASE("stage 6: solution, engine and oracle agree on every scene", "[stage6][agreement]") { check_stage(6); }
TEST_CASE("stage 7: solution, engine and oracle agree on every scene", "[stage7][agreement]") { check_stage(7); }

// Of no stage: nobody's program is graded with these.
TEST_CASE("agreement: solution, engine and oracle agree on every hard scene", "[agreement]") {
  for (int stage = 1; stage <= 7; ++stage) check_stage(stage, Which::hard);
}
