#pragma once

#include "core/render/engine.hpp"

#include <memory>

namespace raylab {

/// The driver with the solution's functions compiled into it, where the compiler can inline every call.
std::unique_ptr<Engine> make_inlined(const Scene& scene, const Settings& settings);

}  // namespace raylab
