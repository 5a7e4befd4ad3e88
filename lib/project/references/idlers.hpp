// Gears that the references of a project show to be idlers.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Where the pinion of one pair is the wheel of another, z_1 = "=first.z_2", or a planet, z_2 = "=set.z_p", the teeth
/// of that gear bend both ways in a turn: sets `idler` in both pairs; what is typed against it is an error. Before the
/// steps are prepared.
void find_idlers(Project& project, std::vector<Issue>& issues);

/// Two gears that turn together and have the same module and number of teeth are one gear, or two on one shaft: where
/// `idler` is neither given nor found, that is an error. After early values are known.
void ask_for_idlers(const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
