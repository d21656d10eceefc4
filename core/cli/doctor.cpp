#include "core/cli/command.hpp"
#include "core/cli/watched_render.hpp"
#include "core/image/data_folder.hpp"
#include "core/submission/sandbox.hpp"
#ifdef RAYLAB_WITH_ENGINE
#include "reference/engine/engine.hpp"
#endif

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>

namespace raylab::cli {
namespace {

void line(const std::string& what, const std::string& how) {
  std::cout << std::left << std::setw(20) << what << how << '\n';
}

#ifdef RAYLAB_WITH_ENGINE
void describe_engine(std::string_view chosen) {
  for (const SimdTarget& target : simd_targets()) {
    const std::string lanes =
        std::to_string(target.lanes_f32) + " f32 or " + std::to_string(target.lanes_f64) + " f64 at a time";
    line(target.name == chosen ? "engine fast" : "",
         std::string(target.name) + ": " + lanes + (target.name == chosen ? "  <- used" : ""));
  }
  line("", "RAYLAB_SIMD=NAME in the environment chooses another one; the image stays the same to the last bit");
}
#endif

#ifdef RAYLAB_WITH_ORACLE
constexpr bool has_oracle = true;
#else
constexpr bool has_oracle = false;
#endif
#ifdef RAYLAB_WITH_TESTS
constexpr bool has_tests = true;
#else
constexpr bool has_tests = false;
#endif

/// What keeps strangers' code from this machine while it is graded.
void describe_sandbox() {
  const Sandbox sandbox;
  std::string what = "sandbox";
  for (const Protection& protection : sandbox.protections())
    line(std::exchange(what, ""), (protection.holds ? "yes  " : "NO   ") + protection.name + ": " + protection.by);
  for (const auto& [layer, why] : sandbox.missing()) line("", "     without " + layer + ": " + why);
  if (!sandbox.is_safe()) line("", "     so 'raylab grade' refuses to run here, but with --unsafe");
}

void diagnose() {
#ifdef RAYLAB_WITH_ENGINE
  const std::string_view simd = default_simd_target();  // throws before anything is printed
#endif
  line("raylab", RAYLAB_VERSION);
  line("threads", std::to_string(thread_count(0)));
  line("engine stages", "f64");
#ifdef RAYLAB_WITH_ENGINE
  describe_engine(simd);
#else
  line("engine fast", "left out of this build");
#endif
  line("engine oracle", has_oracle ? "f237" : "left out of this build");
  line("tests", has_tests ? "built in" : "left out of this build");
  describe_sandbox();
  bool complete = true;
  for (const char* const name : {"scenes", "reference/renders"}) {
    const std::filesystem::path folder = data_folder(name);
    const bool there = std::filesystem::is_directory(folder);
    line(name, folder.string() + (there ? "" : ": MISSING; install raylab again, or put this folder back"));
    complete = complete && there;
  }
  if (!complete) throw CLI::RuntimeError(failure);
}

}  // namespace

void add_doctor(CLI::App& app) {
  CLI::App* command = app.add_subcommand("doctor", "Say what this build and this machine can do");
  command->footer(
      "Exit code: 0 all is there, 1 something is missing.\n\n"
      "Examples:\n"
      "  raylab doctor\n"
      "  RAYLAB_SIMD=sse4 raylab doctor");
  command->callback(diagnose);
}

}  // namespace raylab::cli
