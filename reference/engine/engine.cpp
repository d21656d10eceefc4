#include "reference/engine/engine.hpp"

#include "reference/engine/tracer.hpp"

namespace raylab {
namespace fast {
namespace {

/// A NaN stays one: the program counts and reports it.
double clamped(double c) { return c < 0 ? 0 : c > 1 ? 1 : c; }

template <class T>
class FastEngine : public Engine {
 public:
  FastEngine(const Scene& scene, const Settings& settings) : scene_(prepare<T>(scene, settings)) {}

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    const std::size_t width = static_cast<std::size_t>(scene_.settings.size.width);
    Tracer<T> tracer(scene_, counts, cancel);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (cancel.load(std::memory_order_relaxed)) throw Cancelled{};
      const Color color = tracer.pixel(static_cast<int>(i % width), first_row + static_cast<int>(i / width));
      pixels[i] = {clamped(color.x), clamped(color.y), clamped(color.z)};
    }
  }

 private:
  const Prepared<T> scene_;
};

}  // namespace
}  // namespace fast

std::unique_ptr<Engine> make_fast(const Scene& scene, const Settings& settings, Precision precision) {
  if (precision == Precision::f32) return std::make_unique<fast::FastEngine<float>>(scene, settings);
  return std::make_unique<fast::FastEngine<double>>(scene, settings);
}

}  // namespace raylab
