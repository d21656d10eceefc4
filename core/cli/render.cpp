#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/watched_render.hpp"
#include "core/image/image_file.hpp"
#include "core/image/partial_file.hpp"
#include "core/image/terminal.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

struct Render {
  std::string scene;
  RenderOptions options;
  std::string output;
  std::string stats;
  bool show = false;
};

/// What --stats writes: where the time and the memory went.
struct Statistics {
  double load_seconds = 0;
  double build_seconds = 0;
  double render_seconds = 0;
  std::size_t peak_memory = 0;  ///< the largest that was seen at reports of progress

  void note_memory() { peak_memory = std::max(peak_memory, memory_in_use()); }
};

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void write_stats(const Render& render, const Settings& settings, const EngineFacts& facts, const Statistics& statistics,
                 const RenderTotals& totals) {
  const double pixels = static_cast<double>(settings.size.width) * settings.size.height;
  nlohmann::ordered_json json = {{"scene", render.scene},
                                 {"stage", stage_info(settings.stage).name},
                                 {"engine", render.options.engine},
                                 {"precision", precision_of(render.options)},
                                 {"width", settings.size.width},
                                 {"height", settings.size.height},
                                 {"threads", thread_count(render.options.threads)},
                                 {"load_seconds", statistics.load_seconds},
                                 {"build_seconds", statistics.build_seconds},
                                 {"render_seconds", statistics.render_seconds},
                                 {"trace_seconds", totals.trace_seconds},
                                 {"megapixels_per_trace_second", pixels / 1e6 / totals.trace_seconds},
                                 {"samples", totals.rays.primary},
                                 {"rays",
                                  {{"primary", totals.rays.primary},
                                   {"shadow", totals.rays.shadow},
                                   {"reflected", totals.rays.reflected},
                                   {"refracted", totals.rays.refracted}}},
                                 {"non_finite_pixels", totals.non_finite_pixels},
                                 {"peak_memory_bytes", statistics.peak_memory}};
  if (!facts.simd.empty()) {
    json["simd"] = facts.simd;
    json["hierarchy"] = {
        {"spheres", facts.hierarchy_spheres}, {"seconds", facts.hierarchy_seconds}, {"bytes", facts.hierarchy_bytes}};
  }
  write_file(render.stats, [&](std::ostream& stream) { stream << json.dump(2) << '\n'; });
}

/// Opens `path` in the viewer that the launcher found for this system, if there is a display.
void open_viewer(const fs::path& path) {
  const char* viewer = std::getenv("RAYLAB_VIEWER");
  if (viewer == nullptr || *viewer == '\0') return;
  std::string quoted = "'";
  for (const char c : fs::absolute(path).string()) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  if (std::system((std::string(viewer) + " " + quoted + "' >/dev/null 2>&1 &").c_str()) != 0)
    std::cerr << "raylab: the viewer '" << viewer << "' does not start\n";
}

/// No two of the files that a command names may be the same one: none is to be lost to another.
void require_different_files(const std::vector<fs::path>& paths) {
  for (std::size_t a = 0; a < paths.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (!paths[a].empty() && fs::weakly_canonical(fs::absolute(paths[a])) == fs::weakly_canonical(fs::absolute(paths[b])))
        throw Failure(
            paths[a].string() + ": is both " + (b == 0 ? "the scene and a file to write" : "the image and the statistics"),
            wrong_usage);
}

fs::path output_of(const Render& render, const std::string& name, const std::string& stage) {
  return render.output.empty() ? fs::path("out") / (name + "-" + stage + ".png") : fs::path(render.output);
}

void run(Render& render) {
  Stopwatch watch;
  Statistics statistics;
  const Scene scene = load_scene(render.scene);
  statistics.load_seconds = watch.lap();
  const Settings settings = settings_for(scene, render.options);
  const std::unique_ptr<Engine> engine = make_engine(scene, settings, render.options);
  statistics.build_seconds = watch.lap();
  statistics.note_memory();

  const std::string name = fs::path(render.scene).stem().string();
  const std::string stage(stage_info(settings.stage).name);
  const fs::path output = output_of(render, name, stage);
  require_different_files({render.scene, output, render.stats});
  const auto [width, height] = settings.size;
  interrupt_flag();  // from here on there is something to clean up
  ImageWriter writer(output, width, height);
  std::optional<Preview> preview;
  if (render.show) preview.emplace(width, height, std::min(terminal_columns() - 1, 160), 96);
  const auto sink = [&](int first_row, std::span<const Color> pixels) {
    writer.write_rows(first_row, pixels);
    if (preview) preview->add_rows(first_row, pixels);
  };
  const RenderTotals totals = watched_render(*engine, settings.size, render.options.threads, name + " " + stage, sink,
                                             [&] { statistics.note_memory(); });
  writer.finish();
  statistics.render_seconds = watch.lap();

  if (preview) std::cout << preview->half_blocks();
  std::cout << output.string() << "  " << width << "x" << height << ", " << std::fixed << std::setprecision(2)
            << statistics.render_seconds << " s\n";
  if (!render.stats.empty()) write_stats(render, settings, engine->facts(), statistics, totals);
  if (render.show) open_viewer(output);
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Render a scene at one of its stages");
  const auto render = std::make_shared<Render>();
  command->add_option("SCENE", render->scene, "Scene file (TOML)")->required();
  add_engine_options(*command, render->options);
  add_common_options(*command, render->options);
  command
      ->add_option("-o,--output", render->output,
                   "Image file: .png, .exr, .tif and others; default: out/SCENE-STAGE.png in the working directory")
      ->type_name("FILE");
  command->add_option("--stats", render->stats, "Write times, rays and memory to a JSON file")->type_name("FILE");
  command->add_flag("--show", render->show, "Draw the image in the terminal, and open it where there is a display");
  command->footer(
      "Exit code: 0 rendered, 1 failed, 2 wrong usage, 130 interrupted. A file appears whole or not at all.\n\n"
      "Examples:\n"
      "  raylab render scenes/scene5.toml\n"
      "  raylab render scenes/scene2.toml --stage shadows --show\n"
      "  raylab render scenes/scene3.toml --stage 5 --size 1920x1080 --aa grid16 -o poster.png\n"
      "  raylab render scenes/scene4.toml --engine fast --precision f32 --stats stats.json -o scene4.exr");
  command->callback([render] { run(*render); });
}

}  // namespace raylab::cli
