#pragma once

#include "core/explain/first_difference.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace raylab {

/// Pixels in which the same task is answered differently first.
struct DifferenceGroup {
  Difference difference;            ///< of the pixel that differs most
  std::vector<std::string> pixels;  ///< "120,80", that one first
};

/// How two images of a scene differ.
struct ImageDifferences {
  std::size_t pixels = 0;               ///< of the image
  std::size_t differing = 0;            ///< of them, by more than a step of 255
  std::size_t asked = 0;                ///< about how many was asked
  std::size_t alike = 0;                ///< of these, how many have all calls answered alike
  std::string error;                    ///< why the other image could not be made; the pixels asked are then any
  std::vector<DifferenceGroup> groups;  ///< the largest first
};

/// Compares `table`'s image with `other`'s, and asks about at most `most` of the pixels that differ most.
ImageDifferences find_differences(const Scene& scene, const Settings& settings, const StageTable& table, const Engine& other,
                                  const AskTask& ask, unsigned threads, std::size_t most);

std::string differences_text(const std::string& scene, const Settings& settings, const ImageDifferences& found,
                             const std::string& with);
std::string differences_json(const ImageDifferences& found);

}  // namespace raylab
