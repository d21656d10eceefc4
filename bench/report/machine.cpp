#include "bench/report/machine.hpp"

#include "bench/report/commit.hpp"
#include "reference/engine/engine.hpp"

#include <fstream>
#include <string>
#include <thread>

namespace raylab::bench {
namespace {

#if defined(__clang__)
constexpr const char* compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
constexpr const char* compiler = "g++ " __VERSION__;
#else
constexpr const char* compiler = nullptr;
#endif

/// What stands behind `key` and a colon in a file of such lines, as Linux has them; null if there is none.
Json line_of(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) {
      const std::size_t colon = line.find(':');
      const std::size_t value = line.find_first_not_of(" \t", colon + 1);
      if (colon != std::string::npos && value != std::string::npos) return line.substr(value);
    }
  return nullptr;
}

Json memory_bytes() {
  const Json text = line_of("/proc/meminfo", "MemTotal");
  return text.is_null() ? Json() : Json(1024 * std::stoull(text.get<std::string>()));
}

Json system_name() {
  std::ifstream in("/proc/version");
  std::string name, version, release;
  return in >> name >> version >> release ? Json(name + " " + release) : Json();
}

}  // namespace

Json describe_machine() {
  Json simd = Json::array();
  for (const SimdTarget& target : simd_targets()) simd.push_back(target.name);
  return {{"version", RAYLAB_VERSION},
          {"commit", *commit == '\0' ? Json() : Json(commit)},
          {"modified", commit_modified},
          {"compiler", compiler},
          {"build", RAYLAB_BUILD_TYPE},
          {"flags", RAYLAB_FLAGS},
          {"processor", line_of("/proc/cpuinfo", "model name")},
          {"cores", std::thread::hardware_concurrency()},
          {"memory_bytes", memory_bytes()},
          {"system", system_name()},
          {"simd", std::move(simd)}};
}

}  // namespace raylab::bench
