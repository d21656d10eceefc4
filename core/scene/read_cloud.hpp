#pragma once

#include "core/math/shapes.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/diagnostic.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct CloudTable {
  std::optional<bool> has_colors;  ///< empty if the header does not say
  std::vector<Sphere> spheres;
  std::vector<Color> colors;  ///< one for each sphere, or none
};

/// Reads a table of spheres: a line `x,y,z,radius` or `x,y,z,radius,r,g,b`, then one row of numbers for each sphere.
/// Lines end in LF or CRLF, the last one in either or in nothing. Ranges are those of a [[sphere]] (docs/model.md, "Scene
/// files"). Every wrong field goes to `report` under `key`, "sphere_cloud[0]".
CloudTable parse_cloud(std::string_view text, const std::string& key, Report& report);

}  // namespace raylab
