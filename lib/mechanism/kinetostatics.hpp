// Forces at one position: what the constraints must supply, and how it is shared by the joints.
#pragma once

#include "lib/mechanism/kinematics.hpp"
#include "lib/mechanism/model.hpp"
#include "lib/mechanism/position.hpp"

#include <span>

namespace loadpath::mechanism {

/// Inertia less loads and gravity, per coordinate: the right side of the transposed system for the multipliers.
/// `statics`: without inertia.
void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required);

/// Reactions and efforts from the multipliers; `length`: the unit of length of the constraints, in m.
void share_out(const Model& model, const Constraints& constraints, std::span<const double> q,
               std::span<const double> multipliers, double length, std::span<Reaction> reactions,
               std::span<double> effort);

}  // namespace loadpath::mechanism
