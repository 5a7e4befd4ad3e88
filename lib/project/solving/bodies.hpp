// Steps that describe one physical part, body = "crankshaft": it has one size, the largest that they require, and all
// of them are assessed at it.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// When the project is read: issues for bodies that one step names alone, and for steps without a size in common.
void check_bodies(const Project& project, std::vector<Issue>& issues);

/// When all steps are solved: whether a search has to be made again because the body asks for another size. Sizes that
/// contradict one another become issues.
bool hand_out_sizes(Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
