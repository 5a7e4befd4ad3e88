// The steps of a project file.
#pragma once

#include "lib/project/project.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace loadpath::project {

/// The step of a table, not yet prepared; nothing if name or calculator are wrong.
std::unique_ptr<Step> read_step(const toml::Tree::Entry& entry, const Project& project, Catalogue catalogue,
                                std::vector<Issue>& issues);

/// Words that no step can be called: commands, elements, `project`, `expect`.
std::span<const char* const> reserved_names();
bool is_reserved(std::string_view name);

}  // namespace loadpath::project
