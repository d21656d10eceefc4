#include "core/image/data_folder.hpp"

#include <OpenImageIO/sysutil.h>

namespace raylab {

namespace fs = std::filesystem;

fs::path data_folder(const std::string& name) {
  const fs::path program(OIIO::Sysutil::this_program_path());
  const fs::path installed = (program.parent_path() / RAYLAB_DATA_FROM_PROGRAM).lexically_normal() / name;
  return fs::exists(installed) ? installed : fs::path(RAYLAB_SOURCE_FOLDER) / name;
}

}  // namespace raylab
