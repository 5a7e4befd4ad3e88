// Takes a mechanism through its positions: a revolution of the crank, strokes of cylinders, or the requested
// positions.
#pragma once

#include "calculators/mechanism/cycle/schedule.hpp"
#include "calculators/mechanism/cycle/solved_cycle.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/structure/release.hpp"
#include "lib/quantity/series.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// Whether the positions make series, and over what: the name of the axis; empty where there is one position.
std::string axis_name(const Mechanism::Input& in);
/// Its symbol: of time t, of a stroke s, of the crank angle phi.
std::string axis_symbol(const Axis& axis);

/// The crank angle of the first position, as the user counts it.
double first_crank_angle(const planar::Crank& crank);

/// Fills the places of the axis and solves there. `axis` is null where there is one position. `redundant`: joints hold
/// too much.
Cycle solve_cycle(const Mechanism::Input& in, const mechanism::Model& model, bool redundant, Axis* axis);

}  // namespace loadpath::planar
