#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/load_scene.hpp"
#include "core/cli/watched_render.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/diff_patterns.hpp"
#include "core/image/diff_pictures.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/image_file.hpp"
#include "core/image/partial_file.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/references/other_stage.hpp"
#include "core/report/diff_page.hpp"
#include "core/report/diff_report.hpp"
#include "core/submission/worker_engine.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

constexpr ExitCode cannot_compare = wrong_usage;

struct Diff {
  std::string image;  ///< with --with, the scene
  WithOptions submissions;
  std::string reference;
  std::string scene;
  std::string stage;
  bool json = false;
  std::string out;
};

/// One of the checked-in references, with what is known around it.
struct Chosen {
  fs::path file;
  std::string name;  ///< in words
  int stage = 0;     ///< that was asked for
};

const fs::path& renders() {
  static const fs::path folder = data_folder(manifest_file).parent_path();
  return folder;
}

std::string scene_names(const Manifest& manifest) {
  std::string names;
  for (const SceneEntry& scene : manifest.scenes) names += " " + scene.name;
  return names;
}

const SceneEntry& scene_of(const Manifest& manifest, const std::string& text) {
  if (const SceneEntry* scene = find_scene(manifest, text)) return *scene;
  for (const SceneEntry& scene : manifest.scenes)
    if (fs::is_regular_file(text) && file_hash(text) == scene.sources.front().hash) return scene;  // or a copy
  throw Failure("there are no references of a scene '" + text + "'. There are:" + scene_names(manifest), cannot_compare);
}

Chosen choose(const Diff& diff) {
  if (diff.scene.empty()) return {diff.reference, diff.reference, 0};
  const Manifest manifest = read_manifest(renders() / fs::path(manifest_file).filename());
  const SceneEntry& scene = scene_of(manifest, diff.scene);
  const int stage = find_stage(diff.stage.empty() ? std::string(stage_list().back().name) : diff.stage).number;
  const ReferenceEntry* entry = find_reference(scene, stage);
  if (!entry) throw Failure("scene " + scene.name + " has no reference up to " + stage_title(stage), cannot_compare);
  std::vector<std::string> broken = broken_files(renders(), *entry);
  if (broken.empty()) broken = changed_sources(data_folder(""), scene);
  if (!broken.empty()) throw Failure(broken.front(), cannot_compare);
  std::string name = scene.name + " at " + stage_title(stage);
  if (entry->stage != stage) name += " (nothing has changed since " + stage_title(entry->stage) + ")";
  return {renders() / entry->exr.file, name, stage};
}

/// Before any pixel is decoded.
void require_size(const Diff& diff, const Reference& reference, const std::string& name) {
  const ImageSize size = image_size(diff.image);
  const ImageSize wanted{reference.value.width, reference.value.height};
  if (size.width == wanted.width && size.height == wanted.height) return;
  const auto text = [](ImageSize s) { return std::to_string(s.width) + "x" + std::to_string(s.height); };
  throw Failure(diff.image + ": is " + text(size) + " pixels, and " + name + " is " + text(wanted) +
                    ": render it again with --size " + text(wanted),
                cannot_compare);
}

/// The image that a submission makes of the scene and stage of a reference.
ImageFile rendered_image(const Diff& diff, const Reference& reference, int stage) {
  const Manifest manifest = read_manifest(renders() / fs::path(manifest_file).filename());
  const Scene scene = load_scene(data_folder(scene_of(manifest, diff.scene).sources.front().file));
  const Settings settings{stage, {reference.value.width, reference.value.height}, scene.max_bounces, {}};
  const WorkerSetup setup = build_with(diff.submissions, 1, stage);
  const auto engine = make_worker_engine(scene, settings, setup, thread_count(0), tell_stand_in);
  return {watched_image(*engine, settings.size, 0, diff.scene), NumberFormat::float64};
}

/// The image to judge, which may be a reference itself.
ImageFile values_of(const fs::path& path) {
  Reference reference = read_reference(path);
  return {std::move(reference.value), reference.format};
}

/// `stage`: that was asked for; 0 for the reference's own.
std::optional<Finding> other_stage(const ImageFile& image, const Reference& reference, int stage) {
  const fs::path manifest_path = renders() / fs::path(manifest_file).filename();
  if (!reference.has_word() || !fs::exists(manifest_path)) return {};
  const Manifest manifest = read_manifest(manifest_path);
  const SceneEntry* scene = find_scene(manifest, reference.scene);
  if (!scene) return {};
  return find_other_stage(image.image, image.format, *scene, stage > 0 ? stage : reference.stage, renders());
}

const char* const page_name = "index.html";
const char* const heat_name = "heat.png";
const char* const panels_name = "side-by-side.png";
const char* const json_name = "diff.json";

/// What is compared must not be overwritten by what is said of it.
void require_free_folder(const Diff& diff, const fs::path& reference) {
  if (diff.out.empty()) return;
  const fs::path folder(diff.out);
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw Failure(diff.out + ": is a file: name a folder", cannot_compare);
  for (const char* name : {page_name, heat_name, panels_name, json_name})
    for (const fs::path& input : {fs::path(diff.image), reference})
      if (fs::exists(folder / name) && fs::exists(input) && fs::equivalent(folder / name, input))
        throw Failure(input.string() + ": would be overwritten: name another folder with --out", cannot_compare);
}

/// The pictures and the page; says on `log` what was written.
void write_folder(const fs::path& folder, const DiffTitle& title, const Image& image, Reference reference,
                  const Comparison& comparison, std::ostream& log) {
  const Image panels = side_by_side(image, reference, comparison);
  if (comparison.clamped_each) static_cast<PixelRanges&>(reference) = *reference.each;
  write_image(folder / heat_name, heat_map(comparison));
  write_image(folder / panels_name, panels);
  write_file(folder / json_name, [&](std::ostream& stream) { stream << diff_json(title, comparison); });
  if (image.pixels.size() <= largest_page) {
    const DiffPage page{
        title.image + " and " + title.reference, title.image, title.reference, image, reference, comparison, heat_colors()};
    write_file(folder / page_name, [&](std::ostream& stream) { write_diff_page(stream, page); });
    log << (folder / page_name).string() << '\n';
  } else {
    log << (folder / panels_name).string() << "  (the image is too large for a page: more than " << largest_page
        << " pixels)\n";
  }
}

/// What submissions are called, "my-lab:4": by their folders' own names, though they may be given as ".".
std::string title_of(const std::vector<std::string>& submissions) {
  std::string title;
  for (const std::string& with : submissions) {
    const std::string folder = parse_chosen(with).folder.string();
    const fs::path whole = fs::absolute(fs::path(folder) / "").lexically_normal();
    title += (title.empty() ? "" : " ") + whole.parent_path().filename().string() + with.substr(folder.size());
  }
  return title;
}

/// Returns whether they are the same.
bool run(Diff diff) {
  const bool with = !diff.submissions.with.empty();
  if (with) {
    if (!diff.reference.empty() || !diff.scene.empty())
      throw Failure("with --with, name a scene and nothing else: raylab diff scene2 --stage 4 --with DIR", cannot_compare);
    diff.scene = std::exchange(diff.image, "");
  }
  if (diff.reference.empty() == diff.scene.empty())
    throw Failure("name a reference image, or a scene with --scene: one of both", cannot_compare);
  if (diff.scene.empty() && !diff.stage.empty()) throw Failure("--stage goes with --scene", cannot_compare);
  const Chosen chosen = choose(diff);
  require_free_folder(diff, chosen.file);
  const Reference reference = read_reference(chosen.file);
  if (!with) require_size(diff, reference, chosen.name);
  if (!std::all_of(reference.value.pixels.begin(), reference.value.pixels.end(), is_finite))
    throw Failure(chosen.file.string() + ": has pixels that are not finite numbers: nothing can be compared with them",
                  cannot_compare);
  const ImageFile image = with ? rendered_image(diff, reference, chosen.stage) : values_of(diff.image);
  Comparison comparison = compare(image.image, image.format, reference);
  comparison.findings = find_patterns(image.image, reference, comparison);
  if (!comparison.same)
    if (const auto finding = other_stage(image, reference, chosen.stage))
      comparison.findings.insert(comparison.findings.begin(), *finding);

  const DiffTitle title{with ? title_of(diff.submissions.with) : diff.image, chosen.name};
  std::cout << (diff.json ? diff_json(title, comparison) : diff_text(title, comparison));
  if (!diff.out.empty())
    write_folder(diff.out, title, image.image, reference, comparison, diff.json ? std::cerr : std::cout);
  return comparison.same;
}

}  // namespace

void add_diff(CLI::App& app) {
  CLI::App* command = app.add_subcommand("diff", "Compare an image with a reference, and say how it differs");
  const auto diff = std::make_shared<Diff>();
  command->add_option("IMAGE", diff->image, "The image to judge: PNG, EXR, TIFF and others; with --with, a scene")
      ->required();
  add_with_options(*command, diff->submissions);
  command->add_option("REFERENCE", diff->reference, "Any image of the same size, best one of reference/renders/*/*.exr");
  command->add_option("--scene", diff->scene, "Compare with the checked-in reference of this scene, by name or file");
  command->add_option("--stage", diff->stage, "... at this stage, by name or number; default: the last of all")
      ->type_name("STAGE");
  command->add_flag("--json", diff->json, "Print JSON for programs");
  command
      ->add_option("--out", diff->out,
                   "Write a page to look at (index.html), heat map, pictures side by side and diff.json into this folder")
      ->type_name("DIR");
  command->footer(
      "References are about 160x120 pixels: render with --size 160x120 to an .exr. docs/tolerance.md explains the verdict.\n"
      "Exit code: 0 same, 1 differs, 2 cannot compare.\n\n"
      "Examples:\n"
      "  raylab render scenes/scene3.toml --stage 5 --size 160x120 -o mine.exr\n"
      "  raylab diff mine.exr --scene scene3 --stage 5\n"
      "  raylab diff mine.exr --scene scene3 --stage reflections --out out/diff\n"
      "  raylab diff mine.png theirs.png --json\n"
      "  raylab diff scene2 --stage 4 --with my-lab --out out/diff");
  command->callback([diff] {
    bool same = false;
    try {
      same = run(*diff);
    } catch (const Failure&) {
      throw;
    } catch (const CLI::ParseError&) {
      throw;
    } catch (const std::exception& error) {
      throw Failure(error.what(), cannot_compare);
    }
    if (!same) throw CLI::RuntimeError(failure);
  });
}

}  // namespace raylab::cli
