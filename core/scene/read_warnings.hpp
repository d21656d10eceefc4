#pragma once

#include "core/scene/diagnostic.hpp"
#include "core/scene/scene.hpp"

#include <vector>

namespace raylab {

/// Where the things of a scene stand in its file.
struct ScenePlaces {
  Place camera_position;
  std::vector<Place> planes;
  std::vector<Place> spheres;
  std::vector<Place> clouds;
};

/// Warns of what is legal but surprising (docs/model.md, "Scene files"): a camera inside a sphere, glass that holds or cuts
/// another geometry, a geometry that is there twice. A cloud gets one warning of each kind, however many spheres it is
/// about.
void warn_of_surprises(const Scene& scene, const ScenePlaces& places, Report& report);

}  // namespace raylab
