// Solves the steps of a project in their order.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Solves the steps in order; stops at the first step with an issue.
void solve(Project& project, std::vector<Issue>& issues, Wanted wanted = {});
/// The wanted values, including those that steps and expectations take from one another.
Wanted with_references(const Project& project, Wanted wanted);
/// The same as `solve`, for repeated changes of inputs: `wanted` includes references.
void solve_again(Project& project, std::vector<Issue>& issues, const Wanted& wanted);

}  // namespace loadpath::project
