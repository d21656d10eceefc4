// libFuzzer target for everything that reads a scene file's bytes: any input must give a scene or an error, never a crash.
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -DTOML_HEADER_ONLY=0 -DTOML_SHARED_LIB=1 -I.
//     tests/fuzz/scene_fuzz.cpp core/scene/*.cpp -ltomlplusplus
// The first byte chooses the reader: 'c' for a cloud's table, anything else for a scene.
#include "core/scene/read_cloud.hpp"
#include "core/scene/read_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] == 'c') {
    raylab::Report report("cloud.csv");
    const raylab::CloudTable table = raylab::parse_cloud(text, "sphere_cloud[0]", report);
    const bool rows_kept = table.colors.empty() || table.colors.size() == table.spheres.size();
    if (!rows_kept || (table.spheres.empty() && !report.has_error())) std::abort();
    return 0;
  }
  const raylab::SceneFile file = raylab::parse_scene(text, "no folder/scene.toml");
  bool error = false;
  for (const raylab::Diagnostic& diagnostic : file.diagnostics) {
    error = error || diagnostic.severity == raylab::Diagnostic::Severity::error;
    if (diagnostic.line < 1 || diagnostic.column < 1 || to_string(diagnostic).find('\n') != std::string::npos) std::abort();
  }
  if (file.scene.has_value() == error) std::abort();
  return 0;
}
