// libFuzzer target for reading images: any bytes must give a whole image or an error with the file's name, never a crash.
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I. tests/fuzz/image_fuzz.cpp
//     core/image/{check_exr,check_png,image_file,number_format,open_image,partial_file}.cpp -lOpenImageIO -lOpenImageIO_Util
//   ./a.out CORPUS_FOLDER tests/data/images -timeout=20 -rss_limit_mb=4096
// The libraries behind OpenImageIO are not instrumented: what they do wrong shows only if it crashes.
#include "core/image/image_file.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

std::uint32_t read_number(const std::uint8_t* p) {
  return static_cast<std::uint32_t>(p[0]) << 24U | static_cast<std::uint32_t>(p[1]) << 16U |
         static_cast<std::uint32_t>(p[2]) << 8U | p[3];
}

std::uint32_t checksum(const std::uint8_t* data, std::size_t size) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (std::size_t k = 0; k < size; ++k) {
    sum ^= data[k];
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

/// Makes the checksums of a PNG right again: otherwise no change would get past them.
void mend_png(std::uint8_t* data, std::size_t size) {
  if (size < 8 || std::memcmp(data, "\x89PNG\r\n\x1a\n", 8) != 0) return;
  for (std::size_t at = 8; at + 12 <= size;) {
    const std::size_t length = read_number(data + at);
    if (length > size - at - 12) return;
    const std::uint32_t sum = checksum(data + at + 4, length + 4);
    for (unsigned k = 0; k < 4; ++k) data[at + 8 + length + k] = static_cast<std::uint8_t>(sum >> (24 - 8 * k));
    at += length + 12;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, most);
  mend_png(data, mutated);
  return mutated;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("raylab-fuzz-" + std::to_string(std::random_device{}()) + ".exr");
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const raylab::ImageFile file = raylab::read_image(path);
    const raylab::Image& image = file.image;
    if (image.width < 1 || image.height < 1) std::abort();
    if (image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) std::abort();
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    if (!text.starts_with(path.string() + ": ") || text.find('\n') != std::string::npos) std::abort();
  }
  std::filesystem::remove(path);
  return 0;
}
