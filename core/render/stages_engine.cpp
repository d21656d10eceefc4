#include "core/render/stages_engine.hpp"

#include "core/render/driver.hpp"

namespace raylab {

std::unique_ptr<Engine> make_stages(const Scene& scene, const Settings& settings, const StageTable& table) {
  return std::make_unique<DriverEngine<StageTable>>(scene, settings, table, ray_filters(table, settings.stage));
}

}  // namespace raylab
