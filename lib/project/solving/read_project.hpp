// From the text of a project to its steps, each checked as far as possible before it is solved.
#pragma once

#include "lib/project/project.hpp"
#include "lib/toml/tree.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// Whether an input may be a range or a list of values: `run` takes one value, a sweep goes through all.
enum class Ranges { refused, taken };

/// Reads a project and checks everything that can be known before it runs. With an error among the issues the project
/// must not be solved.
Project read_project(std::string_view text, const std::string& file, Catalogue catalogue, std::vector<Issue>& issues,
                     Ranges ranges = Ranges::refused);
/// The same from a tree that is not a file's: the words of the shell.
Project read_project(const toml::Tree& tree, const std::string& file, Catalogue catalogue, std::vector<Issue>& issues,
                     Ranges ranges = Ranges::refused);

}  // namespace loadpath::project
