#pragma once

#include "core/explain/recording.hpp"
#include "core/math/hit.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// What one light gives to a surface point.
struct LightTerm {
  enum class Kind { ambient, point, directional };
  Kind kind;
  std::size_t number;               ///< among the lights of its kind, from 0
  bool blocked = false;             ///< by what `crossings` has
  Color color;                      ///< black if it is blocked
  std::vector<Crossing> crossings;  ///< what its shadow ray meets; none if there was no need for one
  std::optional<double> distance;   ///< to the light, if there was a shadow ray
};

/// A ray and what came of it.
struct RayNode {
  enum class Kind { camera, reflected, refracted };
  Kind kind = Kind::camera;
  int bounce = 0;
  double weight = 1;  ///< of its color in that of the ray before it
  Ray ray;
  std::optional<double> t;  ///< to what it meets; nothing for the background
  GeometryId geometry = no_geometry;
  std::optional<Vec3> normal;  ///< there, if a task was asked for it or was told it
  std::vector<LightTerm> lights;
  std::vector<RayNode> children;
  std::vector<RayNode> ended;  ///< rays that were not traced: beyond the last bounce, or of weight 0
  Color color;                 ///< seen along it, with its children's parts
};

/// The trees of a pixel, one for each of its samples. `recording` must be record_pixel()'s of that scene.
std::vector<RayNode> ray_trees(const Scene& scene, const Recording& recording);

}  // namespace raylab
