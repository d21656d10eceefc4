#pragma once

// The known mistakes, a file a stage.
#include "tests/mistakes/mistakes.hpp"

#include <vector>

namespace raylab::test {

std::vector<Mistake> mistakes_in_rays();
std::vector<Mistake> mistakes_in_intersections();
std::vector<Mistake> mistakes_in_blinn_phong();
std::vector<Mistake> mistakes_in_shadows();
std::vector<Mistake> mistakes_in_reflections();
std::vector<Mistake> mistakes_in_refraction();
std::vector<Mistake> mistakes_in_ssaa();

}  // namespace raylab::test
