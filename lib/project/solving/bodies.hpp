// Steps that describe one physical part, body = "crankshaft": it has one size, the largest that they require, and all
// of them are assessed at it.
#pragma once

#include "lib/project/project.hpp"

#include <map>
#include <string>
#include <vector>

namespace loadpath::project {

/// The steps of each body.
std::map<std::string, std::vector<Step*>> bodies_of(const Project& project);

/// When the project is read: issues for bodies that only one step names, and for steps without a common size.
void check_bodies(const Project& project, std::vector<Issue>& issues);

/// After all steps are solved: whether a search must be repeated because the body requires another size.
/// Contradicting sizes become issues.
bool hand_out_sizes(Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
