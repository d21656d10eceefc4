#include "core/cli/engines.hpp"

#include "core/cli/command.hpp"
#include "core/cli/watched_render.hpp"
#include "core/render/stages_engine.hpp"
#include "core/submission/worker_engine.hpp"
#ifdef RAYLAB_WITH_ENGINE
#include "reference/engine/engine.hpp"
#include "reference/engine/tasks.hpp"
#endif
#ifdef RAYLAB_WITH_ORACLE
#include "reference/oracle/oracle.hpp"
#include "reference/oracle/tasks.hpp"
#endif

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

extern "C" const raylab::ExportedTasks* raylab_tasks_solution();

namespace raylab::cli {
namespace {

constexpr int last_built_in_stage = 7;  // of the engines that do not run the stage table

const std::map<std::string, AntiAliasing> patterns(aa_patterns.begin(), aa_patterns.end());

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

[[maybe_unused]] void require_built_in_stage(const Settings& settings, const std::string& engine) {
  if (settings.stage > last_built_in_stage)
    throw Failure("--engine " + engine + " knows the stages 1 to " + std::to_string(last_built_in_stage) + ", not " +
                      std::to_string(settings.stage) + ": later ones run with --engine stages",
                  wrong_usage);
}

}  // namespace

void add_common_options(CLI::App& command, RenderOptions& options) {
  command.add_option("--aa", options.aa, "Samples in a pixel, at any stage; default: as the stage says")
      ->check(CLI::IsMember(patterns))
      ->type_name("PATTERN");
  command.add_option("--size", options.size, "Size of an image in place of the scene's")->type_name("WxH");
  command.add_option("--max-bounces", options.max_bounces, "Bounces in place of the scene's, 0 to 100")
      ->check(CLI::Range(0, 100))
      ->type_name("N");
  command.add_option("--threads", options.threads, "Threads to compute with; default: as many as there are cores")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  add_with_options(command, options.submissions);
}

void add_engine_options(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--stage", options.stage, "The last stage that takes part, by name or number; default: the last of all")
      ->type_name("STAGE");
  command
      .add_option("--engine", options.engine, "Who computes: the stages' functions (default), the fast engine or the oracle")
      ->check(CLI::IsMember({"stages", "fast", "oracle"}))
      ->type_name("ENGINE");
  command.add_option("--precision", options.precision, "Of --engine fast; default: f64")
      ->check(CLI::IsMember({"f32", "f64"}))
      ->type_name("PRECISION");
}

const StageInfo& find_stage(const std::string& text) {
  const auto stages = stage_list();
  const auto found = std::find_if(stages.begin(), stages.end(), [&](const StageInfo& stage) {
    return stage.name == text || stage.number == whole_number(text);
  });
  if (found != stages.end()) return *found;
  std::string known;
  for (const StageInfo& stage : stages) known += "\n  " + std::to_string(stage.number) + " " + std::string(stage.name);
  throw CLI::ValidationError("stage", "there is no stage '" + text + "'. The stages are, by number or name:" + known);
}

ImageSize parse_size(const std::string& text) {
  const std::size_t x = text.find('x');
  if (x != std::string::npos) {
    const std::optional<int> width = whole_number(std::string_view(text).substr(0, x));
    const std::optional<int> height = whole_number(std::string_view(text).substr(x + 1));
    const auto fits = [](const std::optional<int>& pixels) { return pixels && *pixels >= 1 && *pixels <= 65536; };
    if (fits(width) && fits(height)) return {*width, *height};
  }
  throw CLI::ValidationError("--size", "wanted WIDTHxHEIGHT, like 640x480, each from 1 to 65536, got '" + text + "'");
}

StageTable solution_table() { return import_tasks(*raylab_tasks_solution()); }

StageTable table_for(const std::string& with, const std::string& precision) {
#ifdef RAYLAB_WITH_ORACLE
  if (precision == "oracle") return oracle_table();
#endif
#ifdef RAYLAB_WITH_ENGINE
  if (with == "fast" && precision != "oracle") return fast_table(precision == "f32" ? Precision::f32 : Precision::f64);
#endif
  if (with == "fast" || precision == "oracle")
    throw Failure((precision == "oracle" ? "--precision oracle" : "--with fast") +
                      std::string(" was left out when this raylab was built"),
                  wrong_usage);
  if (precision == "f32")
    throw Failure("--with solution computes in f64 only: use --with fast for --precision f32", wrong_usage);
  return solution_table();
}

Settings settings_for(const Scene& scene, const RenderOptions& options) {
  Settings settings;
  settings.stage = find_stage(options.stage).number;
  settings.size = options.size.empty() ? scene.image : parse_size(options.size);
  settings.max_bounces = options.max_bounces < 0 ? scene.max_bounces : options.max_bounces;
  if (!options.aa.empty()) settings.aa = patterns.at(options.aa);
  return settings;
}

std::string precision_of(const RenderOptions& options) {
  if (options.engine == "oracle") {
    if (!options.precision.empty())
      throw Failure("--engine oracle has its own precision, more than any --precision: leave that out", wrong_usage);
    return "f237";
  }
  if (options.engine == "stages" && options.precision == "f32")
    throw Failure("--engine stages computes in f64 only: use --engine fast for --precision f32", wrong_usage);
  return options.precision.empty() ? "f64" : options.precision;
}

std::unique_ptr<Engine> make_engine(const Scene& scene, const Settings& settings, const RenderOptions& options) {
  const std::string precision = precision_of(options);
  if (!options.submissions.with.empty()) {
    if (options.engine != "stages") throw Failure("--with goes with --engine stages only, the default", wrong_usage);
    return make_worker_engine(scene, settings, build_with(options.submissions, 1, settings.stage),
                              thread_count(options.threads), tell_stand_in);
  }
  if (options.engine == "stages") return make_stages(scene, settings, solution_table());
#ifdef RAYLAB_WITH_ENGINE
  if (options.engine == "fast") {
    require_built_in_stage(settings, options.engine);
    return make_fast(
        scene, settings,
        {.precision = precision == "f32" ? Precision::f32 : Precision::f64, .threads = thread_count(options.threads)});
  }
#endif
#ifdef RAYLAB_WITH_ORACLE
  if (options.engine == "oracle") {
    require_built_in_stage(settings, options.engine);
    return make_oracle(scene, settings);
  }
#endif
  throw Failure("--engine " + options.engine + " was left out when this raylab was built", wrong_usage);
}

}  // namespace raylab::cli
