// Friction where its sense is not known: of a mechanism at rest, which may be about to move either way, and of joints
// that rest for a moment while the others move, as at a dead point.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "lib/account/block.hpp"

#include <optional>

namespace loadpath::planar {

/// Series of what moves the drive and what holds it, and of the bands at positions where joints rest.
void add_rest_outputs(const mechanism::Model& model, std::vector<Output>& out);
void list_rest_patterns(std::vector<ResultPattern>& patterns);

/// What starts the mechanism and where it stands without its drive; nothing without friction or with several drives.
std::optional<account::Table> standing_table(const mechanism::Model& model, const Cycle& cycle, const Axis* axis);
/// The positions where joints rest while others move, with the forces that their friction may make.
std::optional<account::Table> dead_point_table(const mechanism::Model& model, const Cycle& cycle, const Axis* axis);

}  // namespace loadpath::planar
