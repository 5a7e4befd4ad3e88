// Loads, springs and dampers of a mechanism: from the words of a project to the solver's, over the cycle, and in
// tables.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::planar {

mechanism::Load load_of(const Mechanism::Input& in, const planar::Load& load);
mechanism::Spring spring_of(const Mechanism::Input& in, const planar::Spring& spring);

/// The path of a load: "loads.cut", or by its place in the list, "loads[2]".
std::string path_of(const planar::Load& load, std::size_t index);

/// The points of a spring's ends: as written; the second as the first where missing.
std::pair<Name, Name> end_of(const planar::Spring& spring);

/// Fields of a spring that contradict each other or are missing.
std::vector<FieldFault> check_fields(const planar::Spring& spring);
/// Crank angles of a load's shares that do not rise, or reach round more than a turn. Needs values.
std::vector<FieldFault> check_shares(const Mechanism::Input& in);

/// The share of F and M that acts at a crank angle, given over one period of the crank, rad; 1 where the load does not
/// vary.
double share_at(const planar::Load& load, double crank_angle, double period);

account::Table load_table(const Mechanism::Input& in);
account::Table spring_table(const Mechanism::Input& in);

}  // namespace loadpath::planar
