#include "core/explain/handbook.hpp"

#include "core/image/data_folder.hpp"

#include <filesystem>

namespace raylab {

std::string in_handbook(const std::string& file) {
  for (const char* const folder : {"handbook/stages/", "stages/"})
    if (std::filesystem::exists(folder + file)) return folder + file;
  return (data_folder("stages") / file).string();
}

}  // namespace raylab
