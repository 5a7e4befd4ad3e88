// Masses of links reduced to points, on request of a project (lib/mechanism/studies/reduction.hpp).
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/studies/reduction.hpp"

#include <vector>

namespace loadpath::planar {

/// The link with its own moment of inertia.
mechanism::Link own_of(const planar::Link& link);
/// The point masses of its mass; none where the points do not fit.
std::vector<mechanism::PointMass> masses_of(const planar::Link& link, const mechanism::Link& own);

/// The moment of inertia that the solver takes: of two point masses theirs, else the link's own. kg m^2.
double reduced_inertia(const planar::Link& link, const mechanism::Link& own);

}  // namespace loadpath::planar
