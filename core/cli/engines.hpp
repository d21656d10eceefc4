#pragma once

#include "core/cli/submissions.hpp"
#include "core/render/engine.hpp"
#include "core/render/stage_table.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace raylab::cli {

/// What a user can say about how to render: the options that commands share.
struct RenderOptions {
  std::string stage = std::string(stage_list().back().name);
  std::string engine = "stages";
  std::string precision;
  std::string aa;
  std::string size;
  int max_bounces = -1;
  unsigned threads = 0;
  WithOptions submissions;
};

/// Adds the options that all rendering commands have: --aa, --size, --max-bounces, --threads, --with, --sanitize.
void add_common_options(CLI::App& command, RenderOptions& options);

/// Adds --stage, --engine and --precision.
void add_engine_options(CLI::App& command, RenderOptions& options);

/// The stage that a name ("blinn-phong") or a number ("3") says. Throws CLI::ValidationError that lists the stages.
const StageInfo& find_stage(const std::string& text);

/// The size that a text like "640x480" says. Throws CLI::ValidationError.
ImageSize parse_size(const std::string& text);

/// The reference solution's tasks.
StageTable solution_table();

/// The functions that `raylab call` asks. with: "solution" or "fast", precision: "f32", "f64" or "oracle", which is the same
/// for both; empty for the default. Throws Failure where the two do not go together or this build has no such functions.
StageTable table_for(const std::string& with, const std::string& precision);

/// The settings for `scene` with the user's options in place of the scene's own.
Settings settings_for(const Scene& scene, const RenderOptions& options);

/// The precision that the options lead to: "f32", "f64" or, of the oracle, "f237".
std::string precision_of(const RenderOptions& options);

/// The engine that the options name, prepared for `scene`, which must outlive it. Throws Failure where engine, precision and
/// stage do not go together or the engine was left out of this build.
std::unique_ptr<Engine> make_engine(const Scene& scene, const Settings& settings, const RenderOptions& options);

}  // namespace raylab::cli
