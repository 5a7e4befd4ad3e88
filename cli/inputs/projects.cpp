#include "cli/inputs/projects.hpp"

#include "lib/toml/tree.hpp"

#include <algorithm>
#include <filesystem>

namespace loadpath::cli {

namespace {

namespace fs = std::filesystem;

/// Whether a file is a project, or invalid TOML, which is reported when it is read; tables and templates are neither.
bool may_have_steps(const fs::path& file) {
  std::string text;
  if (!toml::read_file(file.string(), text)) return true;
  std::vector<Issue> issues;
  const toml::Tree tree = toml::read_toml(text, file.string(), issues);
  return has_errors(issues) || std::any_of(tree.entries.begin(), tree.entries.end(),
                                           [](const auto& entry) { return entry.value.find("calculator") != nullptr; });
}

/// The base name for outputs of a file below `folder`; empty for a file given by name.
std::string name_of(const fs::path& file, const fs::path& folder) {
  if (file == "-") return "standard-input";
  const fs::path below = folder.empty() ? file.filename() : file.lexically_relative(folder);
  fs::path name = below.parent_path() / below.stem();
  if (below.stem() == "project") name = below.has_parent_path() ? below.parent_path() : file.parent_path().filename();
  std::string text = name.empty() ? "project" : name.generic_string();
  std::replace(text.begin(), text.end(), '/', '-');
  return text;
}

std::vector<ProjectFile> projects_in(const fs::path& folder) {
  std::vector<ProjectFile> found;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; entry != end && !error; entry.increment(error)) {
    if (entry->path().filename().string().starts_with('.')) {  // files of version control or an editor
      if (entry->is_directory(error)) entry.disable_recursion_pending();
    } else if (entry->path().extension() == ".toml" && fs::is_regular_file(entry->path(), error) &&
               may_have_steps(entry->path())) {
      found.push_back({entry->path().string(), name_of(entry->path(), folder)});
    }
  }
  return found;
}

}  // namespace

std::vector<ProjectFile> projects_of(const std::vector<std::string>& named, std::string& wrong) {
  std::vector<ProjectFile> all;
  for (const std::string& path : named) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      all.push_back({path, name_of(path, {})});
      continue;
    }
    auto found = projects_in(path);
    if (found.empty()) wrong = "no project file in '" + path + "'";
    all.insert(all.end(), found.begin(), found.end());
  }
  const auto key = [](const ProjectFile& p) { return fs::path(p.path).lexically_normal(); };
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  all.erase(std::unique(all.begin(), all.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
            all.end());
  return all;
}

bool are_several(const std::vector<std::string>& named) {
  std::error_code error;
  return named.size() != 1 || fs::is_directory(named[0], error);
}

std::string path_for(const std::string& pattern, const ProjectFile& project) {
  std::string path;
  for (const char c : pattern) path += c == '*' ? project.name : std::string(1, c);
  return path;
}

}  // namespace loadpath::cli
