#pragma once

#include "core/image/diff.hpp"

#include <vector>

namespace raylab {

/// What the difference between an image and its reference looks like, each statement computed from the pixels: "everywhere",
/// "one-object", "edges", "mirrored", "shifted", "brighter", "transfer-curve". Nothing for an image that is the same. The
/// order: first what explains the whole image, then where the pixels outside lie.
std::vector<Finding> find_patterns(const Image& image, const Reference& reference, const Comparison& comparison);

}  // namespace raylab
