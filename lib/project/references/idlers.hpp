// Gears that the references of a project show to be idlers.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// If the pinion of one pair is the wheel of another, z_1 = "=first.z_2", or a planet, z_2 = "=set.z_p", it is an
/// idler with reversed tooth bending: sets `idler` in both pairs; a contradicting typed value is an error. Called
/// before the steps are prepared.
void find_idlers(Project& project, std::vector<Issue>& issues);

/// Two gears that turn together and have the same module and number of teeth are one gear, or two on one shaft: where
/// `idler` is neither given nor found, that is an error. After early values are known.
void ask_for_idlers(const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
