// Errors in parts of a project file other than fields of a calculator.
#pragma once

#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <string>
#include <vector>

namespace loadpath::project {

void add_error(std::vector<Issue>& issues, const Place& place, const std::string& key, Message message,
               Message hint = {});

/// The text of an entry, or an issue and an empty text.
std::string text_of(const toml::Tree::Entry& entry, const std::string& key, std::vector<Issue>& issues);

}  // namespace loadpath::project
