#pragma once

#include "bench/report/unit.hpp"
#include "core/render/stage_table.hpp"
#include "core/scene/scene.hpp"

#include <string>
#include <vector>

namespace raylab::bench {

/// A scene to measure on.
struct BenchScene {
  std::string name;   ///< "scene3", "hard/far_spheres"
  bool hard = false;  ///< one of scenes/hard, made to spoil arithmetic
  Scene world;
};

/// The work on the section "images" of the report: whole images, their speed and their three errors.
///
/// Arithmetic: the same samples, against the oracle. Sampling: against an image of 1024 samples a pixel, by the engine in
/// double. Model: what docs/errata.md accepts, against the oracle.
/// `scenes` and `stages` must outlive the units.
std::vector<Unit> image_units(const Plan& plan, const std::vector<BenchScene>& scenes, const StageTable& stages);

/// That section. What `results` lack, it lacks.
Json image_report(const Plan& plan, const std::vector<BenchScene>& scenes, const Results& results);

}  // namespace raylab::bench
