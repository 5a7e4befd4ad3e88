// Masses of links reduced to points, where a project asks for it (lib/mechanism/studies/reduction.hpp).
#pragma once

#include "calculators/mechanism/words/mechanism.hpp"
#include "calculators/mechanism/words/names.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"

#include <optional>
#include <vector>

namespace loadpath::planar {

/// Points that do not exist or are not asked for. Needs no values.
void check_mass_points(const planar::Link& link, NameFaults& faults);
/// Points that a mass cannot be reduced to. Needs values.
std::vector<FieldFault> check_reductions(const Mechanism::Input& in);

/// The point masses of all links that are reduced; nothing where none is.
std::optional<account::Table> reduction_table(const Mechanism::Input& in);

}  // namespace loadpath::planar
