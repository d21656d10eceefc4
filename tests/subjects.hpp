#pragma once

#include "core/image/reference.hpp"
#include "core/render/engine.hpp"
#include "core/scene/scene.hpp"
#include "tests/runner.hpp"

#include <string>
#include <vector>

namespace raylab::test {

/// A checked-in reference, and the scene that it shows.
struct Subject {
  std::string scene;
  Scene world;
  Reference reference;
};

/// All checked-in references, scene by scene: those of scenes/hard, or all others. Throws std::runtime_error if one cannot
/// be read.
std::vector<Subject> load_subjects(bool hard);

/// The subject as another renderer draws it, at its reference's stage and size.
Image rendered(const Subject& subject, const MakeEngine& make);

}  // namespace raylab::test
