// The machine that the input of machine.motion describes, and its figures.
#pragma once

#include "calculators/machine/motion.hpp"
#include "calculators/machine/motor_run.hpp"

namespace loadpath::machine {

/// `s_K`: breakdown slip; NaN of a motor that is not given by Kloss.
DrivenMachine driven_machine(const Motion::Input& in, double s_K);

/// Speed and torque of the motor over the steady cycle, the run-up over the time, and the moments at the crank.
std::vector<figure::Figure> figures_of(const Motion::Input& in, const DrivenMachine& machine);

}  // namespace loadpath::machine
