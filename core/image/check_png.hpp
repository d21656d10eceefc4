#pragma once

#include <filesystem>

namespace raylab {

/// Looks through the parts of a PNG file without unpacking them. libpng would print its complaints, does not miss the end of
/// a file whose pixels are complete, and unpacks every text and color profile. Throws std::runtime_error with the reason if
/// a part is missing, cut off or damaged, the image is too large, or the file holds much that is no picture.
void check_png(const std::filesystem::path& path);

}  // namespace raylab
