// What steps of one body state about it besides its size: the torque that it transmits, its length, its ends, its
// strength. The less favourable value is that of the body, and a step with another one needs a reason.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// After all steps are solved, with the sizes of their bodies: whether they must be solved again because the body has a
/// less favourable value. A bore that one step has and another has not becomes an issue.
bool hand_out_facts(Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
