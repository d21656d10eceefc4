#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raylab {

/// A submission, as `--with` names it: a directory, and which of its stages and tasks count.
struct Chosen {
  std::filesystem::path folder;
  std::vector<std::string> selections;  ///< "4", "5.1", "1-3"; none: all
};

/// "my-lab", or "my-lab:4,5.1". Throws std::invalid_argument if there is no such stage or task.
Chosen parse_chosen(const std::string& text);

/// The name of a stage's file in a submission: "05_reflections.cpp".
std::string stage_file(int stage);

/// The stages' files that a submission's folder has, by stage. Throws std::runtime_error if it has none, saying what they
/// are called.
std::map<int, std::filesystem::path> stage_files(const std::filesystem::path& folder);

/// What is likely to be a mistake in a submission's folder: a file that is nearly called like a stage's, and a stage that is
/// chosen by its number and has no file. Throws std::runtime_error for the latter.
std::vector<std::string> misnamed_files(const Chosen& chosen);

/// The labels of the tasks of `stage` that are chosen.
std::vector<std::string> chosen_tasks(const Chosen& chosen, int stage);

}  // namespace raylab
