// Masses of links reduced to points, where a project asks for it (lib/mechanism/studies/reduction.hpp).
#pragma once

#include "calculators/mechanism/planar.hpp"
#include "calculators/mechanism/planar_names.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"

#include <optional>
#include <vector>

namespace loadpath {

/// Points that do not exist or are not asked for. Needs no values.
void check_mass_points(const PlanarMechanism::Link& link, NameFaults& faults);
/// Points that a mass cannot be reduced to. Needs values.
std::vector<FieldFault> check_reductions(const PlanarMechanism::Input& in);

/// The moment of inertia that the solver takes: of two point masses theirs, else the link's own. kg m^2.
double reduced_inertia(const PlanarMechanism::Link& link, const mechanism::Link& own);

/// The point masses of all links that are reduced; nothing where none is.
std::optional<account::Table> reduction_table(const PlanarMechanism::Input& in);

}  // namespace loadpath
