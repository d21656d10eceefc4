#pragma once

#include "core/explain/first_difference.hpp"
#include "core/explain/ray_tree.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// What somebody else makes of a pixel.
struct OtherView {
  std::string with;                      ///< whose: "--with my-lab"
  std::optional<Color> color;            ///< nothing if it could not be computed
  std::string error;                     ///< why not
  std::optional<Difference> difference;  ///< nothing if all calls are answered alike
  std::size_t calls = 0;                 ///< how many were asked
};

/// One pixel, explained.
struct Explanation {
  std::string scene;  ///< its file
  Settings settings;
  int column = 0, row = 0;
  Color color;
  std::vector<RayNode> trees;  ///< one for each sample
  std::optional<OtherView> other;
};

/// For people.
std::string explanation_text(const Scene& scene, const Explanation& explanation);

/// For programs: docs/explain.md has the format.
std::string explanation_json(const Scene& scene, const Explanation& explanation);

/// The scene from above and from the side, with the rays drawn.
std::string explanation_svg(const Scene& scene, const Explanation& explanation);

/// A difference by itself: which call, what was asked and answered, which formula is at stake.
std::string difference_text(const Difference& difference, const std::string& with);

/// The values of a JSON object, a line each, for people: "n = (0, 1, 0)". Of one that would be long each member by itself:
/// "hit.point = (1, 2, 3)". What is no object is one line.
std::vector<std::string> value_lines(const std::string& json);

/// What a geometry is called: "sphere[2]", as in messages on scene files; "nothing" for no_geometry.
std::string geometry_name(const Scene& scene, GeometryId id);

/// "point_light[0]"
std::string light_name(const LightTerm& light);

/// "camera", "reflected" or "refracted".
std::string kind_name(RayNode::Kind kind);

}  // namespace raylab
