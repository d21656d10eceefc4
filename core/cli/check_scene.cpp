#include "core/cli/command.hpp"
#include "core/cli/load_scene.hpp"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

void report(const std::string& path, const Scene& scene) {
  const std::size_t lights = scene.point_lights.size() + scene.directional_lights.size() + scene.ambient_lights.size();
  std::cout << path << ": good: " << scene.planes.size() << " planes, " << geometry_count(scene) - scene.planes.size()
            << " spheres, " << lights << " lights, " << scene.image.width << "x" << scene.image.height << ", "
            << scene.max_bounces << " bounces\n";
}

}  // namespace

void add_check_scene(CLI::App& app) {
  CLI::App* command = app.add_subcommand("check-scene", "Report all mistakes of scene files without rendering them");
  const auto paths = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *paths, "Scene files (TOML)")->required();
  command->footer("Exit code: 0 if all are good, 1 if any has a mistake.\n\nExample:\n  raylab check-scene scenes/*.toml");
  command->callback([paths] {
    std::size_t bad = 0;
    for (const std::string& path : *paths) {
      try {
        report(path, load_scene(path));
      } catch (const Failure&) {
        ++bad;
      }
    }
    if (bad > 0) throw Failure(std::to_string(bad) + " of " + std::to_string(paths->size()) + " scene files have mistakes");
  });
}

}  // namespace raylab::cli
