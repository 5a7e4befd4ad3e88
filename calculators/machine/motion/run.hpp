// The motion of a machine with one degree of freedom under its motor, from rest to the steady cycle:
//   d(J(phi) omega^2/2)/dphi = M_motor(omega) - M_load(phi).
// The kinetic energy is integrated over the angle, cell by cell, with steps of controlled error (Dormand and Prince,
// order 5). The steady cycle is the fixed point of the energy from one beginning of the cycle to the next; it is proved
// by a second integration, of the speed over the time. SI numbers.
#pragma once

#include "calculators/machine/motion/machine.hpp"

#include <limits>
#include <vector>

namespace loadpath::machine {

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

/// From rest at the beginning of the cycle. `records`: the points of the run-up too.
MachineRun run_up(const DrivenMachine& machine, bool records);

}  // namespace loadpath::machine
