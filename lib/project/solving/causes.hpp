// One error for each cause: a value of [values] that is wrong is wrong in every step that takes it.
#pragma once

#include "lib/project/project.hpp"
#include "lib/toml/tree.hpp"

#include <vector>

namespace loadpath::project {

/// Keeps of the errors about a value of [values] the first, at the value, and leaves out those of expressions that
/// calculate with it.
void keep_first_of_values(const Project& project, const toml::Tree& file, std::vector<Issue>& issues);

}  // namespace loadpath::project
