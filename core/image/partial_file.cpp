#include "core/image/partial_file.hpp"

#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace raylab {
namespace fs = std::filesystem;

PartialFile::PartialFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) throw std::runtime_error(path_.string() + ": is a folder: name a file in it");
  std::error_code error;
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
  if (error) throw std::runtime_error(path_.string() + ": cannot make its folder: " + error.message());

  if (fs::is_symlink(path_, ignored)) path_ = path_.parent_path() / fs::read_symlink(path_);

  std::ostringstream name;  // not made from the file's own, which may be as long as a name can be
  name << ".partial-" << std::hex << std::random_device{}() << path_.extension().string();
  temporary_ = path_.parent_path() / name.str();
}

PartialFile::~PartialFile() {
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void PartialFile::commit() {
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) throw std::runtime_error(path_.string() + ": cannot be written: " + error.message());
}

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  PartialFile file(path);
  std::ofstream stream(file.temporary(), std::ios::binary);
  write(stream);
  stream.close();
  if (!stream) throw std::runtime_error(path.string() + ": cannot be written");
  file.commit();
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_file(path, [&](std::ostream& stream) { stream << text; });
}

}  // namespace raylab
