#pragma once

#include "core/render/engine.hpp"
#include "core/render/stage_table.hpp"
#include "reference/engine/engine.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace raylab::bench {

/// One way to render an image, at the last stage.
struct ImageVariant {
  std::string renderer;  ///< "fast", "stages" or "textbook"
  std::string precision = "f64";
  std::string simd = {};  ///< of the fast engine: the instruction set
  Formulas formulas = {};
  AntiAliasing aa = AntiAliasing::none;
  std::function<std::unique_ptr<Engine>(const Scene&, const Settings&)> make;

  /// "fast f32 avx512 none", with " textbook-sphere" and " cosine-power" where the formulas are such.
  std::string id() const;

  /// The same but for the instruction set: which changes no bit, and so no error.
  std::string arithmetic_id() const;
};

/// All: the stages' functions, the textbook's renderer in both precisions, the fast engine in both with each instruction set
/// and each choice of formulas that this build has; each with every pattern of `patterns`.
std::vector<ImageVariant> image_variants(const StageTable& stages, const std::vector<AntiAliasing>& patterns);

}  // namespace raylab::bench
