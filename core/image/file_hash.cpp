#include "core/image/file_hash.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace raylab {

std::string file_hash(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty()) throw std::runtime_error(path.string() + ": cannot be read, or is empty");
  return text_hash(bytes);
}

std::string text_hash(std::string bytes) {
  // OpenImageIO brings SHA-1 for pixels; a text is one row of them.
  const OIIO::ImageBuf row(OIIO::ImageSpec(static_cast<int>(bytes.size()), 1, 1, OIIO::TypeDesc::UINT8), bytes.data());
  return OIIO::Strutil::lower(OIIO::ImageBufAlgo::computePixelHashSHA1(row));
}

}  // namespace raylab
