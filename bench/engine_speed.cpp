// How fast the fast engine is: every precision and instruction set in turn, round by round.
//   raylab-bench-engine ROUNDS THREADS SCENE.toml...
// Pin it to one core (taskset -c 1) for one thread. Times are of rendering alone, 1280 x 960 with one sample a pixel.

#include "bench/fma_peak.hpp"
#include "core/render/render.hpp"
#include "core/scene/read_scene.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace raylab;
using Clock = std::chrono::steady_clock;

constexpr ImageSize size{1280, 960};
constexpr double pixels = 1280. * 960;
constexpr double operations_a_pixel = 502;  // in peers/scenes.py's `small`, counted by hand

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Variant {
  std::string name;
  std::unique_ptr<Engine> engine;
  double prepare_seconds = 0;
  std::vector<double> seconds;
  std::vector<double> shares;  ///< of the machine's peak, if the scene is `small`
};

std::vector<Variant> variants_of(const Scene& scene, unsigned threads) {
  std::vector<Variant> variants;
  for (const Precision precision : {Precision::f32, Precision::f64})
    for (const SimdTarget& target : simd_targets()) {
      const auto start = Clock::now();
      auto engine = make_fast(scene, {7, size, scene.max_bounces, AntiAliasing::none},
                              {precision, std::string(target.name), true, threads});
      const double prepare_seconds = seconds_since(start);
      variants.push_back({(precision == Precision::f32 ? "f32 " : "f64 ") + std::string(target.name),
                          std::move(engine),
                          prepare_seconds,
                          {},
                          {}});
    }
  return variants;
}

void time_once(Variant& variant, unsigned threads) {
  const std::atomic<bool> never = false;
  const double peak_before = bench::fma_peak();
  const auto start = Clock::now();
  render(
      *variant.engine, size, threads, [](int, std::span<const Color>) {}, [](double) {}, never);
  const double seconds = seconds_since(start);
  const double peak = 0.5 * (peak_before + bench::fma_peak());
  variant.seconds.push_back(seconds);
  variant.shares.push_back(operations_a_pixel * pixels / seconds / (peak * threads));
}

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

void report(const Variant& variant) {
  const double middle = median(variant.seconds);
  const double least = *std::min_element(variant.seconds.begin(), variant.seconds.end());
  const EngineFacts facts = variant.engine->facts();
  std::printf("  %-12s %8.2f Mpixel/s (best %8.2f)  %.3f of the peak at 502 operations a pixel", variant.name.c_str(),
              pixels / 1e6 / middle, pixels / 1e6 / least, median(variant.shares));
  if (facts.hierarchy_spheres > 0)
    std::printf("  prepared in %.3f s, the hierarchy in %.3f s, %.1f bytes a sphere", variant.prepare_seconds,
                facts.hierarchy_seconds,
                static_cast<double>(facts.hierarchy_bytes) / static_cast<double>(facts.hierarchy_spheres));
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: raylab-bench-engine ROUNDS THREADS SCENE.toml...\n");
    return 2;
  }
  const int rounds = std::max(1, std::atoi(argv[1]));
  const unsigned threads = static_cast<unsigned>(std::max(1, std::atoi(argv[2])));
  for (int i = 3; i < argc; ++i) {
    const SceneFile file = read_scene(argv[i]);
    if (!file.scene) {
      std::fprintf(stderr, "%s: has mistakes; raylab check-scene names them\n", argv[i]);
      return 1;
    }
    std::printf("%s, %u thread%s\n", argv[i], threads, threads == 1 ? "" : "s");
    std::vector<Variant> variants = variants_of(*file.scene, threads);
    for (int round = 0; round < rounds; ++round)
      for (Variant& variant : variants) time_once(variant, threads);
    for (const Variant& variant : variants) report(variant);
  }
  return 0;
}
