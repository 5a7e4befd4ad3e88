// The seats of a shaft next to the records that they take: the width and the forces of a gear, the application factor
// of a connection.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs of a shaft that need a reason: a component narrower than its teeth, an application factor
/// below that of a connection, a component of a tooth force that is changed.
std::vector<ReducedLoad> values_of_seats(const Step& step, const Project& project);

}  // namespace loadpath::project
