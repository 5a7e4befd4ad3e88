// Where the power of the drive goes over a whole turn: friction, useful work, efficiency.
#pragma once

#include "lib/project/step.hpp"

#include <optional>

namespace loadpath {

/// Nothing for a mechanism without friction and useful loads, or without a whole turn: no mean says anything then.
std::optional<report::Table> efficiency_table(const project::Account& account, const Axis* axis);

}  // namespace loadpath
