#include "calculators/machine/motion/machine.hpp"

#include <cmath>

namespace loadpath::machine {

double DrivenMachine::drive(double omega) const {
  const double M = motor_at(omega);
  return ratio * (M >= 0.0 ? M * eta : M / eta);
}

double speed_of(double E, double inertia) { return std::sqrt(2.0 * E / inertia); }

}  // namespace loadpath::machine
