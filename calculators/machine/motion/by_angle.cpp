#include "calculators/machine/motion/by_angle.hpp"

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::machine {

namespace {

namespace odeint = boost::numeric::odeint;

using Along = std::array<double, 5>;  // the members of a RunState
using AngleStepper = odeint::runge_kutta_dopri5<Along>;

constexpr double step_error = 1e-9, least_step_error = 1e-13;
constexpr double shortest_step = 1e-12;  // share of the cell: below, the machine has stopped
constexpr double first_part = 1e-7;      // of the cell, with a constant acceleration

class CellRun {
 public:
  CellRun(const DrivenMachine& machine, const PeriodCell& cell) : machine_(machine), cell_(cell) {}

  /// From a place of the cell, as a share of it, to its end.
  Crossing run(double from, Along& y) {
    const double end = cell_.from + cell_.width, shortest = shortest_step * cell_.width;
    double phi = cell_.from + from * cell_.width, step = from > 0.0 ? from * cell_.width : cell_.width;
    while (end - phi > shortest) {
      auto controlled = odeint::make_controlled(least_step_error, step_error, AngleStepper());
      double at = phi, length = std::min(step, end - phi);
      const double tried = length;
      Along next = y;
      moves_ = true;
      const auto outcome = controlled.try_step(
          [this](const Along& now, Along& slopes, double angle) { find_slopes(now, slopes, angle); }, next, at, length);
      if (moves_ && outcome == odeint::success && next[0] > 0.0) {
        y = next, phi = at, step = length;
        continue;
      }
      step = moves_ && outcome != odeint::success ? length : 0.25 * tried;
      if (step < shortest) return Crossing::stops;
    }
    const double omega = speed_of(y[0], cell_.J.v_1);
    return machine_.ratio * omega > machine_.motor.far_speed() ? Crossing::too_fast : Crossing::done;
  }

  [[nodiscard]] Along at_first() const {
    const double phi = first_part * cell_.width, M = machine_.motor_at(0.0);
    const double E = (machine_.drive(0.0) - cell_.M.v_0) * phi, t = 2.0 * phi / speed_of(E, cell_.J.v_0);
    return {E, t, machine_.ratio * M * phi, M * M * t, M * machine_.motor.omega_0 * t};
  }

 private:
  void find_slopes(const Along& now, Along& slopes, double phi) {
    const double omega = speed_of(now[0], cell_.inertia(phi));
    if (!(omega > 0.0)) {
      moves_ = false;
      slopes.fill(0.0);
      return;
    }
    const double M = machine_.motor_at(omega), omega_0 = machine_.motor.omega_0;
    slopes[0] = machine_.drive(omega) - cell_.load(phi);
    slopes[1] = 1.0 / omega;
    slopes[2] = machine_.ratio * M;
    slopes[3] = M * M / omega;
    slopes[4] = omega_0 > 0.0 ? M * (omega_0 - machine_.ratio * omega) / omega : 0.0;
  }

  const DrivenMachine& machine_;
  const PeriodCell& cell_;
  bool moves_ = true;
};

RunState plus(const RunState& state, const Along& y) {
  return {y[0], state.t + y[1], state.A_shaft + y[2], state.square + y[3], state.slip_heat + y[4]};
}

}  // namespace

// The sums start from zero in each cell: their errors are then relative to what the cell adds.
Crossing cross(const DrivenMachine& machine, const PeriodCell& cell, RunState& state) {
  Along y{state.E, 0.0, 0.0, 0.0, 0.0};
  const Crossing crossing = CellRun(machine, cell).run(0.0, y);
  state = plus(state, y);
  return crossing;
}

Crossing leave(const DrivenMachine& machine, const PeriodCell& cell, RunState& state) {
  CellRun run(machine, cell);
  Along y = run.at_first();
  const Crossing crossing = run.run(first_part, y);
  state = plus(state, y);
  return crossing;
}

}  // namespace loadpath::machine
