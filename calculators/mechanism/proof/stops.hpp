// Where a mechanism that does not close at every position is stopped: the limits of its drive, not of its positions.
#pragma once

#include "calculators/mechanism/results/solved.hpp"
#include "lib/text/issue.hpp"

#include <optional>

namespace loadpath::planar {

/// "not between 124.47 deg and 196.46 deg", "only between 249.1 deg and 410.9 deg", "not above 50.9 deg". None if the
/// limits are not those of one drive, or do not explain which positions are open.
std::optional<Message> stops_of(const Solved& solved);

}  // namespace loadpath::planar
