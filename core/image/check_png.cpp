#include "core/image/check_png.hpp"

#include "core/image/open_image.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

namespace raylab {
namespace {

namespace fs = std::filesystem;

/// Texts and profiles unpack to a thousand times their size, and pictures need none of them.
constexpr std::uint64_t most_side_bytes = 256 << 10;

/// The checksum of PNG (ISO 3309), of one byte.
constexpr std::array<std::uint32_t, 256> byte_checksums = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    table[byte] = sum;
  }
  return table;
}();

class PngParts {
 public:
  explicit PngParts(const fs::path& path) : path_(path), file_(path, std::ios::binary) {
    constexpr std::size_t signature = 8;
    if (read(signature) != "\x89PNG\r\n\x1a\n") damaged("its first bytes are wrong");
  }

  void check() {
    check_header();
    for (std::string name; name != "IEND";) {
      const std::uint32_t length = read_number();
      checksum_ = 0xFFFFFFFFU;
      name = read(4);
      if (name == "IHDR") damaged("it has two headers");
      skip(length);
      check_checksum(name);
      if ((name[0] & 0x20) != 0) count_side_bytes(length);  // a lower-case letter: not needed for the picture
    }
  }

 private:
  [[noreturn]] void damaged(const std::string& why) const {
    refuse_image(path_, "is a PNG that is truncated or damaged (" + why + "): make or copy it again");
  }

  std::string read(std::size_t bytes) {
    std::string text(bytes, '\0');
    if (!file_.read(text.data(), static_cast<std::streamsize>(bytes))) damaged("it ends too early");
    for (const char c : text)
      checksum_ = byte_checksums[(checksum_ ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (checksum_ >> 8U);
    return text;
  }

  std::uint32_t read_number() {
    std::uint32_t number = 0;
    for (const char c : read(4)) number = number << 8U | static_cast<unsigned char>(c);
    return number;
  }

  void check_checksum(const std::string& name) {
    const std::uint32_t computed = ~checksum_;
    if (read_number() != computed) damaged("the checksum of its part " + name + " is wrong");
  }

  void check_header() {
    if (read_number() != 13) damaged("its header is missing");
    checksum_ = 0xFFFFFFFFU;
    if (read(4) != "IHDR") damaged("its header is missing");
    const std::uint32_t width = read_number();
    const std::uint32_t height = read_number();
    read(5);  // the kind of pixels
    check_checksum("IHDR");
    check_image_size(path_, width, height, 1);
  }

  void skip(std::uint32_t length) {
    constexpr std::uint32_t block = 1 << 16;
    for (std::uint32_t left = length; left > 0; left -= std::min(left, block)) read(std::min(left, block));
  }

  void count_side_bytes(std::uint32_t length) {
    side_bytes_ += length;
    if (side_bytes_ > most_side_bytes)
      refuse_image(path_, "holds more than 256 KiB of text and profiles: save it without metadata");
  }

  const fs::path& path_;
  std::ifstream file_;
  std::uint32_t checksum_ = 0;  ///< of what was read since it was set, but for the last inversion
  std::uint64_t side_bytes_ = 0;
};

}  // namespace

void check_png(const fs::path& path) { PngParts(path).check(); }

}  // namespace raylab
