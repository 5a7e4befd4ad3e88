// The part of a project that the steps of one calculator need: these steps, and those that they refer to.
#pragma once

#include "lib/toml/tree.hpp"

#include <string_view>

namespace loadpath::project {

/// The heading, the project's own tables, the steps that run `calculator`, and all that their expressions lead to, in
/// the order of the file. Expectations are left out, and so are the errors of other steps. No steps where none runs the
/// calculator.
toml::Tree part_for(const toml::Tree& project, std::string_view calculator);

/// Whether a table of a project runs this calculator.
bool runs(const toml::Tree::Entry& entry, std::string_view calculator);

}  // namespace loadpath::project
