#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace raylab {

/// A file's bytes, or why there are none.
struct FileText {
  std::optional<std::string> text;
  std::string error;  ///< what is wrong and what to do, empty if there is a text
};

/// Reads a regular file of 1 to `most_bytes` bytes. Never waits: a pipe, a terminal or a device is refused unread.
FileText read_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

}  // namespace raylab
