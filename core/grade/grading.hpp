#pragma once

#include "core/scene/diagnostic.hpp"
#include "core/scene/scene.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// How a stage earns points.
struct StageGrading {
  double points = 0;
  bool bonus = false;
  double images = 0;                ///< the share of the points that hidden images earn; the tasks' is the rest
  std::string shown;                ///< the scene of the published image
  std::vector<std::string> scenes;  ///< of the hidden images
};

/// A call whose answer is compared with the solution's.
struct HiddenTest {
  std::string task;  ///< "2.2"
  std::string call;  ///< the arguments, JSON
};

/// How a class is graded: grading.toml.
struct Grading {
  double call_seconds = 2;
  double image_seconds = 30;
  double submission_seconds = 900;  ///< what is asked of a submission later is too slow
  int megabytes = 1024;
  int hint = 0;                      ///< level, 0 to 3
  double none_at = 0.3;              ///< share of pixels outside with which an image earns nothing
  ImageSize size{64, 48};            ///< of hidden images
  std::vector<StageGrading> stages;  ///< of stage 1 first; all of them
  std::vector<HiddenTest> hidden;
};

/// A grading file, and what was found in it.
struct GradingFile {
  std::optional<Grading> grading;  ///< empty if there is any error
  std::vector<Diagnostic> diagnostics;
};

/// Reads a grading.toml; what it leaves out stays as `defaults` has it. All mistakes are found in one run.
GradingFile read_grading(const std::filesystem::path& path, const Grading& defaults);

/// The part of an image's points that it earns with `outside` of `pixels` pixels outside, where `allowed` may be: 1 up to
/// those, 0 from the share `none_at` on, and between the two falling with the logarithm.
double image_credit(std::size_t outside, std::size_t allowed, std::size_t pixels, double none_at);

}  // namespace raylab
