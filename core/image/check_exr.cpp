#include "core/image/check_exr.hpp"

#include "core/image/open_image.hpp"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace raylab {
namespace {

namespace fs = std::filesystem;

/// Types whose values have one size. OpenEXR reads that many bytes whatever length is given, and would then take for a name
/// and a length what we had passed over.
struct FixedSize {
  std::string_view type;
  std::uint32_t bytes;
};
constexpr FixedSize fixed_sizes[] = {
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
};

bool fits(std::string_view type, std::uint32_t length) {
  for (const FixedSize& fixed : fixed_sizes)
    if (fixed.type == type) return fixed.bytes == length;
  return true;
}

class ExrHeader {
 public:
  explicit ExrHeader(const fs::path& path) : path_(path), file_(path, std::ios::binary) {}

  void check() {
    read_number();  // the signature
    constexpr std::uint32_t several_parts = 0x1000;
    const bool parts = (read_number() & several_parts) != 0;
    // One header is a list of attributes and an empty name. Those of several parts end with an empty list.
    while (check_attributes() && parts) continue;
  }

 private:
  void require(bool good) const {
    if (!good) refuse_image(path_, "is an EXR whose header is truncated or damaged: make or copy it again");
  }

  /// Is there any?
  bool check_attributes() {
    std::string name = read_text();
    if (name.empty()) return false;
    for (; !name.empty(); name = read_text()) {
      const std::string type = read_text();
      const std::uint32_t length = read_number();
      require(fits(type, length));
      const std::streamoff next = file_.tellg() + static_cast<std::streamoff>(length);
      if (name == "dataWindow") check_window();
      if (type == "chlist") check_channels(next);
      file_.seekg(next);  // beyond the end: the next read fails
    }
    return true;
  }

  /// Entries of a name and 16 bytes, the first four its number type, and an empty name. Of another type than half, float and
  /// unsigned int OpenImageIO stops the program.
  void check_channels(std::streamoff end) {
    while (!read_text().empty()) {
      require(read_number() <= 2);
      file_.seekg(12, std::ios::cur);
    }
    require(file_.tellg() == end);
  }

  void check_window() {
    const std::int64_t left = read_coordinate(), top = read_coordinate();
    const std::int64_t right = read_coordinate(), bottom = read_coordinate();
    check_image_size(path_, right - left + 1, bottom - top + 1, 1);
  }

  std::string read_text() {
    std::string text;
    require(static_cast<bool>(std::getline(file_, text, '\0')) && !file_.eof());
    return text;
  }

  std::uint32_t read_number() {
    std::uint32_t number = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
      const int byte = file_.get();
      require(byte >= 0);
      number |= static_cast<std::uint32_t>(byte) << shift;
    }
    return number;
  }

  std::int64_t read_coordinate() { return static_cast<std::int32_t>(read_number()); }

  const fs::path& path_;
  std::ifstream file_;
};

}  // namespace

void check_exr(const fs::path& path) { ExrHeader(path).check(); }

}  // namespace raylab
