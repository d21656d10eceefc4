#include "bench/report/image_variants.hpp"

#include "bench/variants/handout_renderer.hpp"
#include "core/render/stages_engine.hpp"

namespace raylab::bench {
namespace {

constexpr SphereFormula sphere_formulas[] = {SphereFormula::foot, SphereFormula::textbook};
constexpr PowerFormula power_formulas[] = {PowerFormula::log1p, PowerFormula::cosine};

ImageVariant stages_variant(const StageTable& stages) {
  return {.renderer = "stages",
          .make = [stages](const Scene& scene, const Settings& settings) { return make_stages(scene, settings, stages); }};
}

/// It has the textbook's formulas for both, and one thread's plain loops.
ImageVariant textbook_variant(Precision precision) {
  const HandoutBuild build = handout_builds().front();
  const Variant handout{.single_precision = precision == Precision::f32};
  return {.renderer = "textbook",
          .precision = precision == Precision::f32 ? "f32" : "f64",
          .formulas = {SphereFormula::textbook, PowerFormula::cosine},
          .make = [=](const Scene& scene, const Settings& settings) { return build.make(scene, settings, handout); }};
}

ImageVariant fast_variant(Precision precision, const std::string& simd, Formulas formulas) {
  const FastOptions options{.precision = precision, .simd = simd, .formulas = formulas};
  return {.renderer = "fast",
          .precision = precision == Precision::f32 ? "f32" : "f64",
          .simd = simd,
          .formulas = formulas,
          .make = [=](const Scene& scene, const Settings& settings) { return make_fast(scene, settings, options); }};
}

std::vector<ImageVariant> fast_variants(Precision precision) {
  std::vector<ImageVariant> variants;
  for (const SphereFormula sphere : sphere_formulas)
    for (const PowerFormula power : power_formulas)
      for (const SimdTarget& target : simd_targets({sphere, power}))
        variants.push_back(fast_variant(precision, std::string(target.name), {sphere, power}));
  return variants;
}

}  // namespace

std::string ImageVariant::arithmetic_id() const {
  std::string text = renderer + " " + precision;
  if (renderer == "fast" && formulas.sphere == SphereFormula::textbook) text += " textbook-sphere";
  if (renderer == "fast" && formulas.power == PowerFormula::cosine) text += " cosine-power";
  return text + " " + std::string(aa_name(aa));
}

std::string ImageVariant::id() const { return (simd.empty() ? "" : simd + " ") + arithmetic_id(); }

std::vector<ImageVariant> image_variants(const StageTable& stages, const std::vector<AntiAliasing>& patterns) {
  std::vector<ImageVariant> renderers{stages_variant(stages)};
  for (const Precision precision : {Precision::f32, Precision::f64}) {
    renderers.push_back(textbook_variant(precision));
    const std::vector<ImageVariant> fast = fast_variants(precision);
    renderers.insert(renderers.end(), fast.begin(), fast.end());
  }
  std::vector<ImageVariant> variants;
  for (const AntiAliasing aa : patterns)
    for (ImageVariant variant : renderers) {
      variant.aa = aa;
      variants.push_back(variant);
    }
  return variants;
}

}  // namespace raylab::bench
