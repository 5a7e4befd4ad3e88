// What loads a part together with what a step refers to.
#pragma once

#include "lib/project/project.hpp"

#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// Paths of what acts beside the value at a path, for a step that refers to these paths.
std::vector<std::string> companions_of(const Project& project, const std::string& path,
                                       const std::set<std::string>& referred = {});

}  // namespace loadpath::project
