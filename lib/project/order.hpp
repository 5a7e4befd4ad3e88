// The order in which steps follow from one another.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// Indices of steps, each after the steps that it refers to, otherwise in the order of the file. A cycle becomes an
/// issue that names its members; its steps are left out.
std::vector<std::size_t> order_of_evaluation(const Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
