// The structure of a mechanism as a designer reads it: initial links and Assur groups in the order in which they are
// attached. The motion of a group follows from those before it, its reactions from those after it.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/structure/group.hpp"

#include <vector>

namespace loadpath::mechanism {

/// In order of attachment. The model has passed `diagnose`: it is square and its constraints are independent.
std::vector<Group> groups(const Model& model);

}  // namespace loadpath::mechanism
