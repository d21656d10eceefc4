#include "core/cli/render_reference.hpp"

#include "core/cli/command.hpp"
#include "core/cli/watched_render.hpp"
#include "core/render/stage_table.hpp"
#include "reference/engine/engine.hpp"
#include "reference/oracle/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace raylab::cli {
namespace {

constexpr int longer_side = 160;          // of a reference, in pixels
constexpr int longer_side_picture = 320;  // of the picture for people
constexpr int last_stage = 7;

Settings settings(const Scene& scene, int stage, ImageSize size) { return {stage, size, scene.max_bounces, {}}; }

Image rendered_fast(const Scene& scene, int stage, ImageSize size, unsigned threads) {
  const Settings wanted = settings(scene, stage, size);
  return watched_image(*make_fast(scene, wanted, {Precision::f64}), wanted.size, threads, "stages");
}

/// The oracle's word on every `every`-th pixel.
std::vector<PixelWord> words(const Subject& subject, int stage, ImageSize size, int every, unsigned threads) {
  const Settings wanted = settings(subject.scene, stage, size);
  std::vector<PixelWord> all(static_cast<std::size_t>(wanted.size.width) * static_cast<std::size_t>(wanted.size.height));
  const auto engine = make_witness(subject.scene, wanted, all, every);
  watched_render(*engine, wanted.size, threads, subject.name + " " + std::string(stage_info(stage).name), [](int, auto) {});
  return all;
}

Reference reference_of(const Subject& subject, int stage, ImageSize size, const std::vector<PixelWord>& words) {
  const Image blank(size.width, size.height);
  Reference reference{{blank, blank, blank}, PixelRanges{blank, blank, blank}, {}, {}, {}};
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto put_range = [k](PixelRanges& ranges, const ColorRange& range) {
      ranges.value.pixels[k] = range.value;
      ranges.least.pixels[k] = range.least;
      ranges.greatest.pixels[k] = range.greatest;
    };
    put_range(reference, words[k].together);
    put_range(*reference.each, words[k].each);
    reference.margin.push_back(words[k].margin);
    reference.sensitivity.push_back(words[k].sensitivity);
    reference.object.push_back(words[k].object);
  }
  reference.scene = subject.name;
  reference.stage = stage;
  reference.planes = static_cast<int>(subject.scene.planes.size());
  reference.spheres = static_cast<int>(subject.scene.spheres.size());
  return reference;
}

bool clampings_agree(const Reference& reference) {
  return reference.each->value.pixels == reference.value.pixels && reference.each->least.pixels == reference.least.pixels &&
         reference.each->greatest.pixels == reference.greatest.pixels;
}

}  // namespace

std::vector<int> stages_that_change(const Scene& scene, unsigned threads) {
  constexpr double rounding = 1e-9;
  std::vector<int> stages;
  Image before;
  for (int stage = 1; stage <= last_stage; ++stage) {
    Image now = rendered_fast(scene, stage, reference_size(scene), threads);
    const auto close = [](const Color& a, const Color& b) {
      return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= rounding;
    };
    if (stage == 1 || !std::equal(now.pixels.begin(), now.pixels.end(), before.pixels.begin(), close))
      stages.push_back(stage);
    before = std::move(now);
  }
  return stages;
}

ImageSize reference_size(const Scene& scene) { return fitted(scene.image, longer_side); }

Reference oracle_reference(const Subject& subject, int stage, ImageSize size, int every, unsigned threads) {
  const std::vector<PixelWord> all = words(subject, stage, size, every, threads);
  const auto undecided =
      std::count_if(all.begin(), all.end(), [](const PixelWord& word) { return !is_finite(word.together.value); });
  if (undecided > 0)
    throw Failure(subject.name + " at " + stage_title(stage) + ": the oracle's precisions disagree on " +
                  std::to_string(undecided) + " pixels: move the scene's geometries apart");
  Reference reference = reference_of(subject, stage, size, all);
  if (clampings_agree(reference)) reference.each.reset();
  return reference;
}

Image picture(const Scene& scene, int stage, unsigned threads) {
  return rendered_fast(scene, stage, fitted(scene.image, longer_side_picture), threads);
}

}  // namespace raylab::cli
