// Loads that reverse over a cycle, and inputs that claim otherwise.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Before a step is solved: an issue for each input that claims a one-way load whose series reverses. Loads that the
/// step passes on reverse too (LoadFacts::reversal).
void check_senses(Step& step, const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
