#include "core/image/data_folder.hpp"

#include <OpenImageIO/sysutil.h>

namespace raylab {

namespace fs = std::filesystem;

namespace {

fs::path program_folder() { return running_program().parent_path(); }

}  // namespace

fs::path running_program() { return OIIO::Sysutil::this_program_path(); }

fs::path data_folder(const std::string& name) {
  const fs::path installed = (program_folder() / RAYLAB_DATA_FROM_PROGRAM).lexically_normal() / name;
  return fs::exists(installed) ? installed : fs::path(RAYLAB_SOURCE_FOLDER) / name;
}

fs::path program_part(const std::string& name) {
  const fs::path installed = (program_folder() / RAYLAB_PARTS_FROM_PROGRAM).lexically_normal() / name;
  return fs::exists(installed) ? installed : program_folder() / name;
}

}  // namespace raylab
