// Load components that act on a part together with the values that a step refers to.
#pragma once

#include "lib/project/project.hpp"

#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// Paths of the components that act together with the value at a path, for a step that refers to these paths.
std::vector<std::string> companions_of(const Project& project, const std::string& path,
                                       const std::set<std::string>& referred = {});

}  // namespace loadpath::project
