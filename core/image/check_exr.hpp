#pragma once

#include <filesystem>

namespace raylab {

/// Looks through the header of an EXR file. OpenEXR sets aside the memory that a header promises to fill, gigabytes perhaps,
/// before it finds that the file ends.
/// Throws std::runtime_error with the reason if the header is cut off or damaged, or the image is too large.
void check_exr(const std::filesystem::path& path);

}  // namespace raylab
