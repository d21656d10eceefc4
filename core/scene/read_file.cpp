#include "core/scene/read_file.hpp"

#include <fstream>
#include <ios>
#include <system_error>

namespace raylab {
namespace {

namespace fs = std::filesystem;

std::string why_not_readable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return "no such file";
  if (status.type() == fs::file_type::directory) return "a directory; name a file in it";
  if (status.type() == fs::file_type::none) return error.message();
  if (status.type() != fs::file_type::regular) return "a pipe or a device; copy its content to a file";
  return {};
}

std::string why_wrong_size(std::uintmax_t size, std::uintmax_t most_bytes) {
  if (size == 0) return "an empty file";
  if (size > most_bytes) {
    return "too large, " + std::to_string(size) + " bytes, where at most " + std::to_string(most_bytes) + " are read";
  }
  return {};
}

}  // namespace

FileText read_file(const fs::path& path, std::uintmax_t most_bytes) {
  if (std::string why = why_not_readable(path); !why.empty()) return {{}, why};
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return {{}, error.message()};
  if (std::string why = why_wrong_size(size, most_bytes); !why.empty()) return {{}, why};

  std::ifstream file(path, std::ios::binary);
  if (!file) return {{}, "cannot be opened; check that you are allowed to read it"};
  std::string text(static_cast<std::size_t>(size), '\0');
  file.read(text.data(), static_cast<std::streamsize>(size));
  if (file.bad()) return {{}, "cannot be read to its end"};
  text.resize(static_cast<std::size_t>(file.gcount()));  // it may have become shorter since its size was asked for
  return {std::move(text), {}};
}

}  // namespace raylab
