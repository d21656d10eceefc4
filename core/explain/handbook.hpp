#pragma once

#include <string>

namespace raylab {

/// Where a file of the stages' handbook, "02_intersections/README.md", lies for who works in the current folder: in a
/// workspace's handbook/stages, in the project's stages or, from anywhere else, where this raylab keeps it.
std::string in_handbook(const std::string& file);

}  // namespace raylab
