// The order in which steps follow from one another.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Puts the steps in order, each after the steps that it refers to, otherwise in the order of the file. A cycle
/// becomes an issue that names its members, and they and their dependents are left out. Dependencies go to results:
/// if an input of another step would close a cycle, and has its value before that step is solved, it is taken
/// beforehand (Project::beforehand); an optional input waits, if it is taken from a step that needs results of this
/// one: the yield strength of a shaft whose size depends on the notch of its key (Pass::without).
void put_in_order(Project& project, std::vector<Issue>& issues);

/// The value of an input before its step is solved: typed, of a row, or of such inputs; nothing if it has none.
std::optional<Value> value_beforehand(const Project& project, const std::string& path);

}  // namespace loadpath::project
