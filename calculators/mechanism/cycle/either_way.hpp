// Solves a mechanism with friction again where its sense is not known: at rest, and where joints rest for a moment.
#pragma once

#include "calculators/mechanism/cycle/schedule.hpp"
#include "calculators/mechanism/cycle/solved_cycle.hpp"
#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::planar {

/// Whether some joint has dry friction or loses power: what holds a mechanism that rests.
bool has_dry_friction(const mechanism::Model& model);

/// Faults for too many drives at rest to try both directions. Needs values.
std::vector<FieldFault> check_rest(const Mechanism::Input& in, const mechanism::Model& model);

/// Solves the positions that close: fills `either_way`, `standing` and its thresholds.
void solve_either_way(const CycleTask& task, Cycle& cycle);

}  // namespace loadpath::planar
