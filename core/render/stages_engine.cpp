#include "core/render/stages_engine.hpp"

#include "core/render/driver.hpp"

namespace raylab {
namespace {

class StagesEngine final : public Engine {
 public:
  StagesEngine(const Scene& scene, const Settings& settings, const StageTable& table)
      : scene_(scene), settings_(settings), table_(table), filters_(ray_filters(table, settings.stage)) {}

  void trace_rows(int first_row, std::span<Color> pixels, RayCounts& counts,
                  const std::atomic<bool>& cancel) const override {
    Driver<StageTable> driver(scene_, settings_, table_, filters_, counts, cancel);
    const auto width = static_cast<std::size_t>(settings_.size.width);
    for (std::size_t k = 0; k < pixels.size(); ++k)
      pixels[k] = driver.pixel(static_cast<int>(k % width), first_row + static_cast<int>(k / width));
  }

 private:
  const Scene& scene_;
  const Settings settings_;
  const StageTable table_;
  const std::vector<RayFilter> filters_;
};

}  // namespace

std::unique_ptr<Engine> make_stages(const Scene& scene, const Settings& settings, const StageTable& table) {
  return std::make_unique<StagesEngine>(scene, settings, table);
}

}  // namespace raylab
