// How near the fast engine comes to the truth: in double to the checked-in references, in float to these and to double.

#include "core/image/data_folder.hpp"
#include "core/image/diff.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/render/render.hpp"
#include "core/scene/read_scene.hpp"
#include "reference/engine/engine.hpp"
#include "reference/engine/tasks.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace raylab;
using namespace raylab::test;

namespace {

enum class Hard { with, without };  // the scenes of scenes/hard

using Visit = std::function<void(const Scene&, const Reference&)>;

void for_each_reference(Hard hard, const Visit& visit) {
  const std::filesystem::path manifest = data_folder(manifest_file);
  for (const SceneEntry& entry : read_manifest(manifest).scenes) {
    if (hard == Hard::without && is_hard(entry.sources.front().file)) continue;
    const SceneFile file = read_scene(data_folder(entry.sources.front().file));
    REQUIRE(file.scene.has_value());
    for (const ReferenceEntry& at : entry.references) {
      INFO(entry.name << " at stage " << at.stage);
      visit(*file.scene, read_reference(manifest.parent_path() / at.exr.file));
    }
  }
}

Image draw(const Scene& scene, int stage, ImageSize size, Precision precision) {
  return render_image(*make_fast(scene, {stage, size, scene.max_bounces, {}}, {precision}), size, 2);
}

Image draw_as(const Reference& reference, const Scene& scene, Precision precision) {
  return draw(scene, reference.stage, {reference.value.width, reference.value.height}, precision);
}

/// The reference is stored in float: the truth lies up to half a float's step to either side of it. An error far smaller
/// than a step is found all the same, since in some of many pixels the truth is near the middle between two floats.
bool is_within(double bound, const Color& pixel, const Color& stored, NumberFormat format) {
  for (int c = 0; c < 3; ++c)
    if (!(std::abs(pixel[c] - stored[c]) <= bound + half_step(format, stored[c]))) return false;
  return true;
}

/// Of each pixel the worst component's; NaN if one is no number.
std::vector<double> errors_of(const Image& image, const Image& truth) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < image.pixels.size(); ++k) errors.push_back(deviation(image.pixels[k], truth.pixels[k]));
  return errors;
}

/// The signal-to-noise ratio, of a peak of 1.
double decibels(const std::vector<double>& errors) {
  double sum_of_squares = 0;
  for (const double error : errors) sum_of_squares += error * error;
  return -10 * std::log10(sum_of_squares / static_cast<double>(errors.size()));
}

/// Of float against double. The references are smaller, and the oracle would take a quarter of an hour for the margins of
/// one picture of this size. So no pixel is left out, whatever decision it hangs on: that asks for more.
std::vector<double> float_errors(const Scene& scene, int stage) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // minutes, which tell nothing new
  const ImageSize size{160, 120};
#else
  const ImageSize size{640, 480};
#endif
  return errors_of(draw(scene, stage, size, Precision::f32), draw(scene, stage, size, Precision::f64));
}

/// Nine balls of a third of the radius around each: six at its equator and three above.
void grow_flake(std::vector<Sphere>& spheres, const Sphere& ball, const Vec3& up, int levels) {
  spheres.push_back(ball);
  if (levels == 0) return;
  const Vec3 x = normalize(cross(up, std::abs(up.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  const Vec3 y = cross(up, x);
  for (int child = 0; child < 9; ++child) {
    const bool above = child >= 6;
    const double angle = above ? pi / 6 + child * 2 * pi / 3 : child * pi / 3;
    const Vec3 across = std::cos(angle) * x + std::sin(angle) * y;
    const Vec3 out = above ? std::sqrt(1. / 3) * across + std::sqrt(2. / 3) * up : across;
    grow_flake(spheres, {ball.center + 4. / 3 * ball.radius * out, ball.radius / 3}, out, levels - 1);
  }
}

/// The scene flake4 of bench/peers/scenes.py, but that its balls are turned a little.
Scene flake() {
  Scene scene;
  scene.max_bounces = 2;
  scene.camera = {{2.1, 1.3, 1.7}, {-2.1, -1.3, -1.7}, {0, 0, 1}, 28.9};
  scene.planes = {{{{0, 0, -0.5}, {0, 0, 1}}, {{1, 0.75, 0.33}, 20, false, 1.5}}};
  SphereCloud cloud;
  cloud.material = {{1, 0.9, 0.7}, 100, false, 1.5};
  grow_flake(cloud.spheres, {{0, 0, 0}, 0.5}, {0, 0, 1}, 4);
  scene.clouds = {cloud};
  scene.point_lights = {{{4, 3, 2}, 16}, {{1, -4, 4}, 18}};
  scene.directional_lights = {{{3, -1, -5}, 0.3}};
  scene.ambient_lights = {{0.1}};
  return scene;
}

}  // namespace

TEST_CASE("engine: in double every pixel is its reference but for rounding", "[engine]") {
  for_each_reference(Hard::with, [](const Scene& scene, const Reference& reference) {
    const Image image = draw_as(reference, scene, Precision::f64);
    std::size_t judged = 0, beyond = 0;
    for (std::size_t k = 0; k < image.pixels.size(); ++k) {
      if (reference.margin[k] <= 1e-9) continue;
      ++judged;
      const double bound = 1e-12 + 8 * reference.sensitivity[k];
      beyond += !is_within(bound, image.pixels[k], reference.value.pixels[k], reference.format);
    }
    CHECK(beyond == 0);
    CHECK(judged >= image.pixels.size() / 2);  // all, but where a lamp lies in a ceiling
  });
}

// What float makes of the hard scenes is measured, and not promised: docs/hard_scenes.md.
TEST_CASE("engine: in float every picture is its reference to 65 dB but for flips", "[engine]") {
  for_each_reference(Hard::without, [](const Scene& scene, const Reference& reference) {
    const std::vector<double> errors = errors_of(draw_as(reference, scene, Precision::f32), reference.value);
    std::vector<double> judged;
    std::size_t flips = 0;
    for (std::size_t k = 0; k < errors.size(); ++k) {
      if (reference.margin[k] <= 1e-5) continue;
      const double explained = calibrated.gain * reference.sensitivity[k] + calibrated.floor;  // docs/tolerance.md
      if (errors[k] <= explained)
        judged.push_back(errors[k]);
      else
        ++flips;
    }
    CHECK(decibels(judged) >= 65);
    CHECK(flips < errors.size() / 1000);
  });
}

TEST_CASE("engine: in float the five scenes at full size are those in double to 65 dB", "[engine]") {
  for (const std::string name : {"scene1", "scene2", "scene3", "scene4", "scene5"})
    for (const int stage : {6, 7}) {
      INFO(name << " at stage " << stage);
      const SceneFile file = read_scene(data_folder("scenes/" + name + ".toml"));
      REQUIRE(file.scene.has_value());
      const std::vector<double> errors = float_errors(*file.scene, stage);
      CHECK(decibels(errors) >= 65);
      // Flips, or rounding that mirrors have amplified to more than 1e-4.
      const auto flips = std::count_if(errors.begin(), errors.end(), [](double error) { return error > 1e-4; });
      CHECK(flips < static_cast<std::ptrdiff_t>(errors.size() / 1000));
    }
}

TEST_CASE("engine: in float a flake of 7,381 spheres is that in double to 60 dB", "[engine]") {
  const Scene scene = flake();
  REQUIRE(scene.clouds[0].spheres.size() == 7381);
  CHECK(decibels(float_errors(scene, 5)) >= 60);
}

TEST_CASE("engine: in float a flake that is far from zero is that in double to 60 dB, too", "[engine]") {
  Scene scene = flake();
  const Vec3 away(3e6, -1e6, 2e6);
  scene.camera.position += away;
  scene.planes[0].shape.point += away;
  for (PointLight& light : scene.point_lights) light.position += away;
  for (Sphere& ball : scene.clouds[0].spheres) ball.center += away;
  CHECK(decibels(float_errors(scene, 5)) >= 60);
}

TEST_CASE("engine: a highlight is the true one to two roundings, from its peak down to where it ends", "[engine]") {
  const auto [precision, rounding] = GENERATE(std::pair(Precision::f32, 0x1p-24L), std::pair(Precision::f64, 0x1p-53L));
  const double alpha = GENERATE(1, 20, 400);
  const StageTable table = fast_table(precision);
  const Vec3 n = {0, 0, 1};
  const long double k_s = table.specular_weight(alpha);
  for (int k = 0; k <= 1200; ++k) {
    const double tilt = 0.0025 * k;
    const Vec3 v = {static_cast<float>(std::sin(tilt)), 0, static_cast<float>(std::cos(tilt))};  // the same in either
    const long double tangent = v.x / (1 + static_cast<long double>(v.z));  // of H's angle: cos^2 = 1 / (1 + tan^2)
    const long double truth = 1 + k_s * std::exp(-alpha / 2 * std::log1p(tangent * tangent));
    INFO("alpha " << alpha << ", tilt " << tilt);
    REQUIRE(std::abs(table.blinn_phong(n, n, v, 1, Color(1), alpha).x - truth) <= 2 * rounding * truth);
  }
}
