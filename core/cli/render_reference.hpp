#pragma once

#include "core/image/reference.hpp"
#include "core/scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::cli {

/// A scene whose references are to be made or checked.
struct Subject {
  std::string name;
  std::vector<std::filesystem::path> sources;  ///< the scene file, its tables, the model; relative to the data folder
  Scene scene;
};

// threads: 0 for as many as there are cores. All draw a progress bar, and throw Cancelled on Ctrl-C.

/// The stages that need a reference: those whose image is not that of the stage before.
std::vector<int> stages_that_change(const Scene& scene, unsigned threads);

/// The size of a scene's references.
ImageSize reference_size(const Scene& scene);

/// The oracle's word on every `every`-th pixel, those that is_sampled() names, as a reference; the others are black.
/// Throws Failure if the oracle cannot decide a pixel.
Reference oracle_reference(const Subject& subject, int stage, ImageSize size, int every, unsigned threads);

/// The picture for people: larger, by the fast engine in double.
Image picture(const Scene& scene, int stage, unsigned threads);

}  // namespace raylab::cli
