// A machine with one degree of freedom: the torque of its motor, and over the angle of its crank the load and the
// reduced moment of inertia. SI numbers.
#pragma once

#include "calculators/machine/motion/motor_curve.hpp"
#include "calculators/machine/motion/periodic_cells.hpp"

#include <vector>

namespace loadpath::machine {

struct DrivenMachine {
  MotorCurve motor;
  double ratio = 1.0, eta = 1.0;  // speed of the motor over that of the crank; efficiency between them
  double period = 0.0;            // rad
  std::vector<PeriodCell> cells;

  [[nodiscard]] double motor_at(double omega) const { return motor.at(ratio * omega); }
  /// The torque of the motor at the crank; where the machine drives its motor, the losses are on the other side.
  [[nodiscard]] double drive(double omega) const;
};

/// What is integrated over the angle.
struct RunState {
  double E = 0.0;          // kinetic energy, J
  double t = 0.0;          // s
  double A_shaft = 0.0;    // work of the motor at its shaft, J
  double square = 0.0;     // integral of the square of its torque over the time
  double slip_heat = 0.0;  // integral of its torque times its slip speed over the time, J; zero of a line
};

double speed_of(double E, double inertia);

}  // namespace loadpath::machine
