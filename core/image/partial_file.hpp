#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace raylab {

/// A file that appears under its name whole or not at all: it is written under another name in the same folder, and takes
/// its own with commit(). Without commit() it is removed.
class PartialFile {
 public:
  /// Makes the folder if it is missing. Throws std::runtime_error if that fails or `path` is a folder itself.
  explicit PartialFile(std::filesystem::path path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Where to write. A hidden name that no other run uses; it ends like the file's own.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Gives the finished, closed file its name. Throws std::runtime_error if that fails.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
};

/// Writes a file that appears whole or not at all. Throws std::runtime_error if it cannot be written, and what `write`
/// throws.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace raylab
