// The steady cycle of a machine once more, as angle and speed over the time: a proof of its integration over the angle.
#pragma once

#include "calculators/machine/motion/machine.hpp"

namespace loadpath::machine {

/// From the kinetic energy at the beginning of the cycle over its duration: by how much the angle misses the period, or
/// the speed its first value, whichever is more, as a share of it. NaN if there is no such motion.
double difference_by_time(const DrivenMachine& machine, double E, double duration);

}  // namespace loadpath::machine
