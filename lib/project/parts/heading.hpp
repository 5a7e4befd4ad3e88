// The heading of a project file, [project]: the texts of the report's title block, and settings.
#pragma once

#include "lib/project/project.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

struct HeadingKey {
  const char* key;
  const char* meaning;
  bool in_title_block = false;  // of a report, in a place of its own
};

std::span<const HeadingKey> heading_keys();
std::vector<std::string> heading_names();
bool is_in_title_block(std::string_view key);

void read_heading(const toml::Tree::Entry& entry, Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
