// Traces a scene once, in one thread and into memory, for feature_cost.sh to count the instructions of trace_image():
//   raylab-feature-cost SCENE.toml STAGE none|rotated4|adaptive f32|f64
// Prints a hash of the colors. RAYLAB_SIMD says which instructions.

#include "core/scene/read_scene.hpp"
#include "reference/engine/engine.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <span>
#include <string>
#include <vector>

using namespace raylab;

/// Has a name of its own that callgrind finds, whatever the kernel's entry is called.
extern "C" [[gnu::noinline]] void trace_image(const Engine& engine, ImageSize size, std::vector<Color>& pixels) {
  const std::atomic<bool> never = false;
  const auto width = static_cast<std::size_t>(size.width);
  RayCounts counts;
  for (int row = 0; row < size.height; row += engine.rows_at_once()) {
    const auto rows = static_cast<std::size_t>(std::min(engine.rows_at_once(), size.height - row));
    engine.trace_rows(row, std::span(pixels).subspan(static_cast<std::size_t>(row) * width, rows * width), counts, never);
  }
}

namespace {

/// FNV-1a
std::uint64_t hash_of(const std::vector<Color>& pixels) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::byte byte : std::as_bytes(std::span(pixels)))
    hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
  return hash;
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, AntiAliasing> patterns = {
      {"none", AntiAliasing::none}, {"rotated4", AntiAliasing::rotated4}, {"adaptive", AntiAliasing::adaptive}};
  if (argc != 5 || !patterns.contains(argv[3])) {
    std::fprintf(stderr, "usage: raylab-feature-cost SCENE.toml STAGE none|rotated4|adaptive f32|f64\n");
    return 2;
  }
  const SceneFile file = read_scene(argv[1]);
  if (!file.scene) {
    std::fprintf(stderr, "%s: has mistakes; raylab check-scene names them\n", argv[1]);
    return 1;
  }
  const Scene& scene = *file.scene;
  const Precision precision = std::string(argv[4]) == "f32" ? Precision::f32 : Precision::f64;
  const auto engine =
      make_fast(scene, {std::atoi(argv[2]), scene.image, scene.max_bounces, patterns.at(argv[3])}, {precision});
  std::vector<Color> pixels(static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height));
  trace_image(*engine, scene.image, pixels);
  std::printf("%016" PRIx64 "\n", hash_of(pixels));
  return 0;
}
