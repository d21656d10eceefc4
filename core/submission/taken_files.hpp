#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raylab {

/// What is taken of a submission: the texts of its stages' files, and nothing else.
struct TakenFiles {
  std::map<int, std::string> texts;    ///< by stage
  std::map<int, std::string> refused;  ///< by stage: why its file is not taken
  std::vector<std::string> notes;      ///< what the instructor should know
};

/// Reads a submission's folder, without following a link in it, or waiting for a pipe. If it has none of the files and one
/// subfolder has, that is taken, as archives often have one. Of a folder that cannot be
/// read all files are refused.
TakenFiles take_files(const std::filesystem::path& folder);

/// Has the folder something that is called like a stage's file, or keeps it to itself?
bool is_submission(const std::filesystem::path& folder);

}  // namespace raylab
