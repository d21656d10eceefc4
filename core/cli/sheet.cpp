#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/watched_render.hpp"
#include "core/image/image_file.hpp"
#include "core/image/label.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

constexpr int default_tile_width = 320;
constexpr int columns = 4;
constexpr int gap = 12;
constexpr int largest_tile = 4096;  // the page is kept in memory
constexpr int label_scale = 2;
constexpr int label_height = label_row * label_scale + 6;
const Color paper(0.11);
const Color ink(0.92);
const Color faint_ink(0.6);

struct Sheet {
  std::string scene;
  RenderOptions options;
  std::string output;
};

/// Where the k-th tile stands on the sheet.
struct Place {
  int column, row;
};

Place place_of(int k, ImageSize tile) {
  return {gap + k % columns * (tile.width + gap), gap + k / columns * (tile.height + label_height + gap)};
}

Image empty_sheet(int tiles, ImageSize tile) {
  const Place last = place_of((tiles - 1) / columns * columns, tile);
  const int across = std::min(tiles, columns);
  return Image(gap + across * (tile.width + gap), last.row + label_height + tile.height + gap, paper);
}

/// As much of `text` as fits into `width` pixels.
std::string fitting(std::string text, int width) {
  const auto room = static_cast<std::size_t>(std::max(0, width / (label_column * label_scale)));
  if (text.size() > room) text.resize(room);
  return text;
}

ImageSize default_tile(const Scene& scene) {
  return {default_tile_width, std::max(1, scene.image.height * default_tile_width / scene.image.width)};
}

void run(const Sheet& sheet) {
  const Scene scene = load_scene(sheet.scene);
  const std::string name = fs::path(sheet.scene).stem().string();
  const auto stages = stage_list();
  const ImageSize tile = sheet.options.size.empty() ? default_tile(scene) : parse_size(sheet.options.size);
  if (std::max(tile.width, tile.height) > largest_tile)
    throw Failure("--size: a picture on a sheet is at most " + std::to_string(largest_tile) + " pixels wide and high",
                  wrong_usage);
  Image page = empty_sheet(static_cast<int>(stages.size()), tile);

  for (const StageInfo& stage : stages) {
    RenderOptions options = sheet.options;
    options.stage = stage.name;
    Settings settings = settings_for(scene, options);
    settings.size = tile;
    const std::unique_ptr<Engine> engine = make_engine(scene, settings, options);
    const Place place = place_of(stage.number - 1, tile);
    const std::string label = std::to_string(stage.number) + " " + std::string(stage.name);
    draw_label(page, place.column, place.row + 2, fitting(label, tile.width), ink, label_scale);
    const auto sink = [&](int first_row, std::span<const Color> pixels) {
      for (std::size_t k = 0; k < pixels.size(); ++k)
        page.at(place.column + static_cast<int>(k) % tile.width,
                place.row + label_height + first_row + static_cast<int>(k) / tile.width) = pixels[k];
    };
    watched_render(*engine, tile, options.threads, name + " " + label, sink);
  }

  if (stages.size() % columns != 0) {  // the free place after the last picture
    const Place free = place_of(static_cast<int>(stages.size()), tile);
    draw_label(page, free.column, free.row + 2, fitting(name, tile.width), ink, label_scale);
    draw_label(page, free.column, free.row + label_height, fitting(scene.title, tile.width), faint_ink, label_scale);
  }

  const fs::path output = sheet.output.empty() ? fs::path("out") / (name + "-sheet.png") : fs::path(sheet.output);
  write_image(output, page);
  std::cout << output.string() << "  " << page.width << "x" << page.height << "\n";
}

}  // namespace

void add_sheet(CLI::App& app) {
  CLI::App* command = app.add_subcommand("sheet", "Render a scene at all stages into one labelled picture");
  const auto sheet = std::make_shared<Sheet>();
  command->add_option("SCENE", sheet->scene, "Scene file (TOML)")->required();
  add_common_options(*command, sheet->options);
  command
      ->add_option("-o,--output", sheet->output,
                   "Image file: .png, .exr, .tif and others; default: out/SCENE-sheet.png in the working directory")
      ->type_name("FILE");
  command->footer(
      "The size of one stage's picture is 320 pixels across, unless --size says more.\n\n"
      "Examples:\n"
      "  raylab sheet scenes/scene5.toml\n"
      "  raylab sheet scenes/scene4.toml --size 640x480 -o scene4-stages.png");
  command->callback([sheet] { run(*sheet); });
}

}  // namespace raylab::cli
