// A power, torque or pull of [values] that no step takes, next to a drive whose load is stated as another quantity.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// "P = 12 kW" next to T_1 and n_1 of 5 kW, "T_2 = 200 N*m" next to P and n_1. They need a reason; loads under their
/// own names are compared in machine/left_out.hpp.
std::vector<ReducedLoad> loads_stated_otherwise(const Step& step, const Project& project);

/// The same next to gears of geometry only, in a project without a loaded drive: their strength is not assessed.
std::vector<ReducedLoad> loads_of_unloaded_gears(const Step& step, const Project& project);

/// "P = 100 kW" next to a smaller torque at the speed of the step or of [values], or next to a torque without a speed.
std::vector<ReducedLoad> powers_of_torques(const Step& step, const Project& project);

/// "P = =values.P/values.K_A" in a step that applies this factor again: it has no effect then.
std::vector<ReducedLoad> factors_cancelled(const Step& step, const Project& project);

/// Whether a step is a drive: a speed at both sides, and the load as a power or a torque.
bool is_drive(const Step& step);

}  // namespace loadpath::project
