// The motion of a machine with one degree of freedom under its motor, from rest to the steady cycle:
//   d(J(phi) omega^2/2)/dphi = M_motor(omega) - M_load(phi).
// The kinetic energy is integrated over the angle, cell by cell, with steps of controlled error (Dormand and Prince,
// order 5). The steady cycle is the fixed point of the energy from one beginning of the cycle to the next; it is proved
// by a second integration, of the speed over the time. SI numbers.
#pragma once

#include "calculators/machine/motor_curve.hpp"
#include "calculators/machine/periodic_cells.hpp"

#include <array>
#include <limits>
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

struct RunPoint {
  double t = 0.0, omega = 0.0;
};

struct MachineRun {
  enum class End { steady, no_start, stalled, runs_away, not_settled };
  static constexpr double settled = 0.005;  // speed below that of the steady cycle at which the run-up is over

  End end = End::not_settled;
  double t = std::numeric_limits<double>::quiet_NaN(), angle = t;  // of the run-up; NaN if it takes too many turns
  double heat = t;                                                 // slip heat of the run-up
  double stall = t;             // stalled: load over the torque of the motor at rest, at the place where it stops
  double closure = t;           // relative error of the energy of the steady cycle, at most
  double by_time = t;           // relative difference of the steady cycle from its integration over the time
  std::vector<RunState> cycle;  // the steady cycle, at the borders of its cells; time and works from its beginning
  std::vector<RunPoint> start;  // the run-up, if it is recorded
};

double speed_of(double E, double inertia);

/// From rest at the beginning of the cycle. `records`: the points of the run-up too.
MachineRun run_up(const DrivenMachine& machine, bool records);

}  // namespace loadpath::machine
