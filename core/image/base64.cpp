#include "core/image/base64.hpp"

#include <OpenImageIO/strutil.h>

namespace raylab {

std::string base64(std::string_view bytes) {
  return OIIO::Strutil::base64_encode(OIIO::string_view(bytes.data(), bytes.size()));
}

}  // namespace raylab
