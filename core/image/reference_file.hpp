#pragma once

#include "core/image/reference.hpp"

#include <filesystem>

namespace raylab {

/// Writes an EXR of 32-bit floats: R, G, B are the values, and beside them are the channels
///   below.R, above.R, ...  how far the least and the greatest value lie from the value
///   each.R, each.below.R, each.above.R, ...  the same with each dot product clamped by itself, each.R as the distance from
///   R;
///                                           only if anything there differs
///   margin, sensitivity    rounded to the safe side, in three binary digits: down, and up
///   object                 -1 for background
/// Like every image, the file appears whole or not at all, and the same reference gives the same bytes.
/// Throws std::runtime_error if it cannot be written.
void write_reference(const std::filesystem::path& path, const Reference& reference);

/// Reads a reference, or any other image of channels R, G, B as a reference that knows nothing beside its values.
/// Throws std::runtime_error as read_image() does, and for a reference whose channels are incomplete or make no sense.
Reference read_reference(const std::filesystem::path& path);

/// The reference as write_reference() and read_reference() would bring it back, which rounds its numbers.
Reference as_stored(const Reference& reference);

/// What a pixel's object is called: "plane[0]", "sphere[2]" as in messages about the scene file, "cloud sphere 17" counted
/// over all clouds, "background".
std::string object_name(const Reference& reference, GeometryId object);

}  // namespace raylab
