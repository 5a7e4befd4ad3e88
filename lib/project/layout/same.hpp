// Whether two texts of a project have the same meaning.
#pragma once

#include "lib/toml/tree.hpp"

namespace loadpath::project {

/// The same keys with the same values, quantities to the bit. The order of keys counts, but for those of a step, and
/// for the heading, shared values and tables among the steps.
bool say_the_same(const toml::Tree& a, const toml::Tree& b);

}  // namespace loadpath::project
