// The kinetic energy of a machine over the angle of its crank, across one cell of its period.
#pragma once

#include "calculators/machine/motion/machine.hpp"

namespace loadpath::machine {

enum class Crossing { done, stops, too_fast };

/// Across a cell; the machine moves at its beginning.
Crossing cross(const DrivenMachine& machine, const PeriodCell& cell, RunState& state);
/// Across a cell from rest at its beginning, where the motor is stronger than the load.
Crossing leave(const DrivenMachine& machine, const PeriodCell& cell, RunState& state);

}  // namespace loadpath::machine
