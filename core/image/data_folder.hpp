#pragma once

#include <filesystem>
#include <string>

namespace raylab {

/// A file or folder of the project's data, "scenes" or "reference/renders", wherever this copy of raylab keeps it: installed
/// beside the running program, or in the source folder that it was built from.
std::filesystem::path data_folder(const std::string& name);

/// The running program's own file.
std::filesystem::path running_program();

/// What belongs to the running program but is none for users, "raylab-worker": installed apart, or built beside it.
std::filesystem::path program_part(const std::string& name);

}  // namespace raylab
