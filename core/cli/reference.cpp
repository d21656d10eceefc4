#include "core/cli/command.hpp"
#include "core/cli/engines.hpp"
#include "core/cli/watched_render.hpp"
#include "core/image/data_folder.hpp"
#include "core/image/file_hash.hpp"
#include "core/image/image_file.hpp"
#include "core/image/reference_file.hpp"
#include "core/references/manifest.hpp"
#include "core/scene/read_scene.hpp"
#if defined(RAYLAB_WITH_ORACLE) && defined(RAYLAB_WITH_ENGINE)
#include "core/cli/render_reference.hpp"
#include "reference/oracle/oracle.hpp"
#define RAYLAB_CAN_MAKE_REFERENCES
#endif

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace raylab::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> scenes;
  bool update = false;
  bool check = false;
  bool all = false;
  unsigned threads = 0;
};

#ifdef RAYLAB_CAN_MAKE_REFERENCES

constexpr int sample_every = 16;  // pixels that --check renders, without --all: 6 %

const fs::path renders = fs::path(manifest_file).parent_path();

class ReferenceMaker {
 public:
  explicit ReferenceMaker(const Options& options) : options_(options), data_(data_folder("")) {}

  /// Renders what is missing or made from something else than now; the manifest is written after each image, so that an
  /// interrupted run keeps what it had.
  void update() {
    Manifest manifest = fs::exists(data_ / manifest_file) ? read_manifest(data_ / manifest_file) : Manifest{};
    int rendered = 0;
    const std::vector<Subject> wanted = subjects();
    forget_gone_scenes(manifest);
    for (const Subject& subject : wanted) {
      const SceneEntry* known = find_scene(manifest, subject.name);
      const SceneEntry old = known ? *known : SceneEntry{};
      SceneEntry entry{subject.name, {}, {}};
      for (const fs::path& source : subject.sources) entry.sources.push_back(hashed(source));
      const bool fresh = same(old.sources, entry.sources) && !options_.all;
      for (const int stage : stages_of(subject)) {
        const ReferenceEntry* kept = fresh ? entry_of(old, stage) : nullptr;
        if (kept && holds(*kept)) {
          entry.references.push_back(*kept);
          continue;
        }
        entry.references.push_back(render(subject, stage));
        std::cout << (data_ / renders / entry.references.back().exr.file).string() << std::endl;
        ++rendered;
        put(manifest, fresh ? merged(entry, old) : entry);
      }
      put(manifest, entry);
    }
    if (options_.scenes.empty()) remove_unlisted(manifest);
    std::cout << rendered << " references rendered, " << count(manifest) << " in all\n";
  }

  /// Throws Failure if anything does not hold.
  void check() {
    const Manifest manifest = read_manifest(data_ / manifest_file);
    const std::vector<Subject> wanted = subjects();
    std::vector<std::string> broken = broken_promises(data_, manifest);
    std::size_t pixels = 0;
    if (broken.empty())
      for (const Subject& subject : wanted)
        for (const ReferenceEntry& entry : find_scene(manifest, subject.name)->references)
          pixels += check(subject, entry, broken);
    for (const std::string& sentence : broken) std::cerr << "raylab: " << sentence << '\n';
    if (!broken.empty()) throw Failure("the references do not hold: " + std::to_string(broken.size()) + " complaints");
    std::cout << count(manifest) << " references hold; " << pixels << " pixels rendered again\n";
  }

 private:
  HashedFile hashed(const fs::path& file) const { return {file.generic_string(), file_hash(data_ / file)}; }

  std::vector<Subject> subjects() const {
    std::vector<fs::path> files;
    for (const auto& file : fs::recursive_directory_iterator(data_ / "scenes"))
      if (file.path().extension() == ".toml") files.push_back(file.path());
    std::sort(files.begin(), files.end());
    std::map<std::string, fs::path> names;
    for (const fs::path& file : files)
      if (!names.emplace(file.stem().string(), file).second)
        throw Failure(file.string() + " and " + names[file.stem().string()].string() +
                      ": two scenes of one name, under which references are kept: rename one");
    std::vector<Subject> all;
    for (const fs::path& file : files)
      if (options_.scenes.empty() || is_wanted(file)) all.push_back(subject(file));
    if (all.empty()) throw Failure("no such scene in " + (data_ / "scenes").string(), wrong_usage);
    return all;
  }

  bool is_wanted(const fs::path& file) const {
    return std::any_of(options_.scenes.begin(), options_.scenes.end(), [&](const std::string& wanted) {
      return file.stem() == wanted || (fs::exists(wanted) && fs::equivalent(file, wanted));
    });
  }

  Subject subject(const fs::path& file) const {
    SceneFile read = read_scene(file);
    if (!read.scene) throw Failure(file.string() + ": has mistakes: 'raylab check-scene' lists them");
    Subject subject{file.stem().string(), {fs::relative(file, data_)}, std::move(*read.scene)};
    for (const fs::path& table : read.tables) subject.sources.push_back(fs::relative(table, data_));
    subject.sources.push_back("docs/model.md");
    return subject;
  }

  /// Of a hard scene only the last, the whole picture: it is there for its arithmetic, not for the stages.
  std::vector<int> stages_of(const Subject& subject) const {
    std::vector<int> stages = stages_that_change(subject.scene, options_.threads);
    if (is_hard(subject.sources.front())) stages.erase(stages.begin(), stages.end() - 1);
    return stages;
  }

  static bool same(const std::vector<HashedFile>& a, const std::vector<HashedFile>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const HashedFile& x, const HashedFile& y) { return x.file == y.file && x.hash == y.hash; });
  }

  static const ReferenceEntry* entry_of(const SceneEntry& scene, int stage) {
    const ReferenceEntry* found = find_reference(scene, stage);
    return found && found->stage == stage ? found : nullptr;
  }

  bool holds(const ReferenceEntry& entry) const { return broken_files(data_ / renders, entry).empty(); }

  /// What is finished of an entry, and of the old one what comes after.
  static SceneEntry merged(SceneEntry entry, const SceneEntry& old) {
    const int finished = entry.references.back().stage;
    for (const ReferenceEntry& reference : old.references)
      if (reference.stage > finished) entry.references.push_back(reference);
    return entry;
  }

  /// Files of scenes that are gone, and of stages that no longer change anything.
  void remove_unlisted(const Manifest& manifest) const {
    std::set<fs::path> listed;
    for (const SceneEntry& scene : manifest.scenes)
      for (const ReferenceEntry& entry : scene.references) listed.insert({entry.exr.file, entry.png.file});
    std::vector<fs::path> unlisted;
    for (const auto& file : fs::recursive_directory_iterator(data_ / renders)) {
      const fs::path extension = file.path().extension();
      const bool is_render = extension == ".exr" || extension == ".png";
      if (is_render && !listed.contains(file.path().lexically_relative(data_ / renders))) unlisted.push_back(file.path());
    }
    for (const fs::path& file : unlisted) fs::remove(file);
  }

  void forget_gone_scenes(Manifest& manifest) const {
    std::erase_if(manifest.scenes, [&](const SceneEntry& scene) { return !fs::exists(data_ / scene.sources.front().file); });
  }

  void put(Manifest& manifest, const SceneEntry& entry) const {
    std::erase_if(manifest.scenes, [&](const SceneEntry& scene) { return scene.name == entry.name; });
    const auto place = std::upper_bound(
        manifest.scenes.begin(), manifest.scenes.end(), entry,
        [](const SceneEntry& a, const SceneEntry& b) { return a.sources.front().file < b.sources.front().file; });
    manifest.scenes.insert(place, entry);
    write_manifest(data_ / manifest_file, manifest);
  }

  static std::size_t count(const Manifest& manifest) {
    std::size_t sum = 0;
    for (const SceneEntry& scene : manifest.scenes) sum += scene.references.size();
    return sum;
  }

  ReferenceEntry render(const Subject& subject, int stage) const {
    const fs::path folder(stage_info(stage).folder);
    const fs::path exr = folder / (subject.name + ".exr");
    const fs::path png = folder / (subject.name + ".png");
    write_reference(data_ / renders / exr,
                    oracle_reference(subject, stage, reference_size(subject.scene), 1, options_.threads));
    write_image(data_ / renders / png, picture(subject.scene, stage, options_.threads));
    return {stage,
            {exr.generic_string(), file_hash(data_ / renders / exr)},
            {png.generic_string(), file_hash(data_ / renders / png)}};
  }

  /// Compares a reference with what the oracle gives; returns how many pixels.
  std::size_t check(const Subject& subject, const ReferenceEntry& entry, std::vector<std::string>& broken) const {
    const int every = options_.all ? 1 : sample_every;
    const std::string name = (data_ / renders / entry.exr.file).string();
    const Reference kept = read_reference(name);
    const Reference now =
        as_stored(oracle_reference(subject, entry.stage, reference_size(subject.scene), every, options_.threads));
    if (kept.value.width != now.value.width || kept.value.height != now.value.height) {
      broken.push_back(name + ": has another size than the scene gives: run 'raylab reference --update'");
      return 0;
    }
    std::size_t compared = 0, different = 0;
    for (int row = 0; row < now.value.height; ++row)
      for (int column = 0; column < now.value.width; ++column)
        if (is_sampled(column, row, every)) {
          const auto k =
              static_cast<std::size_t>(row) * static_cast<std::size_t>(now.value.width) + static_cast<std::size_t>(column);
          ++compared;
          if (!same_pixel(kept, now, k)) ++different;
        }
    if (different > 0)
      broken.push_back(name + ": " + std::to_string(different) + " of " + std::to_string(compared) +
                       " pixels are not what the oracle gives: run 'raylab reference --update --all'");
    check_png(subject, entry, broken);
    return compared;
  }

  static bool same_pixel(const Reference& a, const Reference& b, std::size_t k) {
    const auto same = [k](const PixelRanges& x, const PixelRanges& y) {
      return x.value.pixels[k] == y.value.pixels[k] && x.least.pixels[k] == y.least.pixels[k] &&
             x.greatest.pixels[k] == y.greatest.pixels[k];
    };
    const auto each = [](const Reference& reference) -> const PixelRanges& {
      return reference.each ? *reference.each : static_cast<const PixelRanges&>(reference);
    };
    return same(a, b) && same(each(a), each(b)) && a.margin[k] == b.margin[k] && a.sensitivity[k] == b.sensitivity[k] &&
           a.object[k] == b.object[k];
  }

  void check_png(const Subject& subject, const ReferenceEntry& entry, std::vector<std::string>& broken) const {
    const std::string name = (data_ / renders / entry.png.file).string();
    const Image kept = read_image(name).image;
    const Image now = picture(subject.scene, entry.stage, options_.threads);
    const auto close = [](const Color& a, const Color& b) {
      const auto level = [](double c) { return static_cast<int>(quantise(c)); };
      return std::abs(level(a.r) - level(b.r)) <= 1 && std::abs(level(a.g) - level(b.g)) <= 1 &&
             std::abs(level(a.b) - level(b.b)) <= 1;
    };
    if (kept.width != now.width ||
        !std::equal(kept.pixels.begin(), kept.pixels.end(), now.pixels.begin(), now.pixels.end(), close))
      broken.push_back(name + ": is not what the fast engine gives: run 'raylab reference --update --all'");
  }

  const Options& options_;
  const fs::path data_;
};

#endif

void run(const Options& options) {
  if (options.update == options.check) throw Failure("say either --update or --check", wrong_usage);
#ifdef RAYLAB_CAN_MAKE_REFERENCES
  interrupt_flag();
  ReferenceMaker maker(options);
  options.update ? maker.update() : maker.check();
#else
  throw Failure("oracle and fast engine, which make the references, were left out when this raylab was built", wrong_usage);
#endif
}

}  // namespace

void add_reference(CLI::App& app) {
  CLI::App* command = app.add_subcommand("reference", "Render the checked-in references, or check them");
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scenes, "Scenes by name or file; default: all in scenes/");
  command->add_flag("--update", options->update, "Render references that are missing or whose scene or model has changed");
  command->add_flag("--check", options->check,
                    "Check the manifest's hashes, and render a fixed sample of 6 % of the pixels again");
  command->add_flag("--all", options->all, "With --update: render all of them; with --check: all pixels");
  command->add_option("--threads", options->threads, "Threads to compute with; default: as many as there are cores")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->footer(
      "References are in reference/renders, with a manifest of what they were made from. An interrupted update keeps what "
      "is\n"
      "finished, and goes on from there.\n"
      "Exit code: 0 done, or all hold; 1 failed, or something does not hold; 130 interrupted.\n\n"
      "Examples:\n"
      "  raylab reference --check\n"
      "  raylab reference --check --all scene3\n"
      "  raylab reference --update");
  command->callback([options] { run(*options); });
}

}  // namespace raylab::cli
