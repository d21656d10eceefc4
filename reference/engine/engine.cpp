#include "reference/engine/engine.hpp"

#include "reference/engine/kernel.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace raylab {
namespace fast {
namespace {

template <class T>
class FastEngine : public Engine {
 public:
  FastEngine(Prepared<T> scene, std::string_view simd, TraceRows<T> trace)
      : scene_(std::move(scene)), facts_(scene_.facts), trace_(trace) {
    facts_.simd = simd;
  }

  int rows_at_once() const override { return 8; }
  EngineFacts facts() const override { return facts_; }

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    trace_(scene_, first_row, pixels, counts, cancel);
  }

 private:
  const Prepared<T> scene_;
  EngineFacts facts_;
  const TraceRows<T> trace_;
};

std::vector<Kernel> with_scalar(std::vector<Kernel> packs, const Kernel& scalar) {
  packs.push_back(scalar);
  return packs;
}

std::vector<Kernel> kernels(Formulas formulas = {}) {
#ifdef RAYLAB_WITH_FORMULAS
  if (formulas == foot_cosine::formulas) return with_scalar(foot_cosine::pack_kernels(), foot_cosine::scalar_kernel);
  if (formulas == textbook_log1p::formulas)
    return with_scalar(textbook_log1p::pack_kernels(), textbook_log1p::scalar_kernel);
  if (formulas == textbook_cosine::formulas)
    return with_scalar(textbook_cosine::pack_kernels(), textbook_cosine::scalar_kernel);
#endif
  if (formulas != foot_log1p::formulas) return {};
  return with_scalar(foot_log1p::pack_kernels(), foot_log1p::scalar_kernel);
}

Kernel find_kernel(std::string_view simd, const std::string& who, Formulas formulas = {}) {
  const std::vector<Kernel> all = kernels(formulas);
  const auto found = std::find_if(all.begin(), all.end(), [&](const Kernel& kernel) { return kernel.simd == simd; });
  if (found != all.end()) return *found;
  std::string known;
  for (const Kernel& kernel : all) known += (known.empty() ? "" : ", ") + std::string(kernel.simd);
  throw std::invalid_argument(who + ": there is no '" + std::string(simd) + "' on this machine; there are " +
                              (known.empty() ? "none" : known));
}

}  // namespace
}  // namespace fast

std::vector<SimdTarget> simd_targets(Formulas formulas) {
  std::vector<SimdTarget> targets;
  for (const fast::Kernel& kernel : fast::kernels(formulas))
    targets.push_back({kernel.simd, kernel.lanes_f32, kernel.lanes_f64});
  return targets;
}

std::string_view default_simd_target() {
  const char* const wanted = std::getenv("RAYLAB_SIMD");
  if (wanted == nullptr || *wanted == '\0') return fast::kernels().front().simd;
  return fast::find_kernel(wanted, "RAYLAB_SIMD").simd;
}

std::unique_ptr<Engine> make_fast(const Scene& scene, const Settings& settings, const FastOptions& options) {
  const fast::Kernel kernel = fast::find_kernel(
      options.simd.empty() ? default_simd_target() : std::string_view(options.simd), "instruction set", options.formulas);
  const auto make = [&]<class T>(fast::TraceRows<T> trace) -> std::unique_ptr<Engine> {
    auto prepared = fast::prepare<T>(scene, settings, options.hierarchy, std::max(1u, options.threads));
    return std::make_unique<fast::FastEngine<T>>(std::move(prepared), kernel.simd, trace);
  };
  return options.precision == Precision::f32 ? make(kernel.trace_f32) : make(kernel.trace_f64);
}

}  // namespace raylab
