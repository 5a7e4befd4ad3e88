// Loads that change their sense over a cycle, and inputs that say otherwise.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Before a step is solved: an issue for each input that claims one sense of a load whose series has both. What the
/// step hands on changes its sense too (LoadFacts::reversal).
void check_senses(Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
