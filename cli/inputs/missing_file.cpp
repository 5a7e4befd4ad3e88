#include "cli/inputs/missing_file.hpp"

#include "lib/text/issue.hpp"

#include <filesystem>
#include <system_error>
#include <vector>

namespace loadpath::cli {

std::string help_for_file(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(file, error)) return "a project is a text file that you may read";
  const fs::path path(file);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
  }
  std::string near = nearest(path.filename().string(), names);
  if (near.empty() && !path.has_extension()) near = nearest(path.filename().string() + ".toml", names);
  if (near.empty()) return "no such file";
  return "did you mean '" + (path.parent_path() / near).string() + "'?";
}

}  // namespace loadpath::cli
