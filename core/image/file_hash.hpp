#pragma once

#include <filesystem>
#include <string>

namespace raylab {

/// The SHA-1 of a file's bytes, in hexadecimal, as sha1sum prints it. Throws std::runtime_error if it cannot be read.
std::string file_hash(const std::filesystem::path& path);

/// The same of a text that is not empty.
std::string text_hash(std::string bytes);

}  // namespace raylab
