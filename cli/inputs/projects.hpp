// The project files that a command is given: files, and those that lie in folders.
#pragma once

#include <string>
#include <vector>

namespace loadpath::cli {

struct ProjectFile {
  std::string path;  // as it is read; "-" is standard input
  std::string name;  // for outputs: "press" of examples/press/project.toml, "shaft" of shaft.toml
};

/// Named files as they are, and for a folder, searched recursively, every .toml that has a step, sorted by path. A
/// folder without any is reported in `wrong`.
std::vector<ProjectFile> projects_of(const std::vector<std::string>& named, std::string& wrong);

/// Whether this is more than one file, or a folder.
bool are_several(const std::vector<std::string>& named);

/// The path of an output of one of several projects: with its name for every *.
std::string path_for(const std::string& pattern, const ProjectFile& project);

}  // namespace loadpath::cli
