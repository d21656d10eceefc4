#pragma once

#include <filesystem>
#include <vector>

namespace raylab {

/// Makes `folder`, with a student's seven files to fill in, a README, the handbook, scenes and references: copied from this
/// raylab's data. It appears whole or not at all.
/// solutions: the stages whose solution goes into solutions/.
/// Throws std::runtime_error if the folder exists and is not empty, data are missing, or this raylab holds the solution only
/// compiled.
void make_workspace(const std::filesystem::path& folder, const std::vector<int>& solutions);

/// Makes the tree that a course publishes: a workspace for machines on which raylab is installed from its Debian package.
/// package: that file, to be handed out with it; empty for none. Throws std::runtime_error as make_workspace() does.
void make_handout(const std::filesystem::path& folder, const std::filesystem::path& package);

}  // namespace raylab
