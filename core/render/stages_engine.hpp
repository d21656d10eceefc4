#pragma once

#include "core/render/engine.hpp"
#include "core/render/stage_table.hpp"

#include <memory>

namespace raylab {

/// The engine that runs a stage table: the driver asks its functions for everything. Double precision.
/// `scene` must live as long as the engine. Whatever a task throws comes out of trace_rows().
std::unique_ptr<Engine> make_stages(const Scene& scene, const Settings& settings, const StageTable& table);

}  // namespace raylab
