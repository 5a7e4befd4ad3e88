#include "calculators/machine/motion/by_time.hpp"

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::machine {

namespace {

namespace odeint_of_time = boost::numeric::odeint;

using AngleAndSpeed = std::array<double, 2>;
using TimeStepper = odeint_of_time::runge_kutta_dopri5<AngleAndSpeed>;

const PeriodCell& cell_at(const DrivenMachine& machine, double phi) {
  const auto next = std::upper_bound(machine.cells.begin(), machine.cells.end(), phi,
                                     [](double angle, const PeriodCell& cell) { return angle < cell.from; });
  return next == machine.cells.begin() ? machine.cells.front() : *(next - 1);
}

/// J epsilon + J' omega^2/2 = M.
AngleAndSpeed slopes_at(const DrivenMachine& machine, const AngleAndSpeed& now) {
  const double phi = now[0] - machine.period * std::floor(now[0] / machine.period), omega = now[1];
  const PeriodCell& cell = cell_at(machine, phi);
  const double M = machine.drive(omega) - cell.load(phi);
  return {omega, (M - 0.5 * cell.inertia_slope(phi) * omega * omega) / cell.inertia(phi)};
}

}  // namespace

double difference_by_time(const DrivenMachine& machine, double E, double duration) {
  constexpr double error = 1e-9, least_error = 1e-12, shortest = 1e-10, across_leap = 1e-8;
  constexpr int most_steps = 100'000;
  const double omega_0 = speed_of(E, machine.cells.front().J.v_0), longest = duration / 360.0;
  AngleAndSpeed y{0.0, omega_0};
  double t = 0.0, step = longest;
  const auto system = [&](const AngleAndSpeed& now, AngleAndSpeed& slopes, double) {
    slopes = slopes_at(machine, now);
  };
  for (int k = 0; k < most_steps && duration - t > shortest * duration; ++k) {
    auto controlled = odeint_of_time::make_controlled(least_error, error, TimeStepper());
    double at = t, length = std::min({step, longest, duration - t});
    AngleAndSpeed next = y;
    const auto outcome = controlled.try_step(system, next, at, length);
    if (outcome == odeint_of_time::success) {
      y = next, t = at, step = length;
    } else if (step = length; length < across_leap * duration) {  // short enough for the proof, whatever happens there
      TimeStepper().do_step(system, y, t, length);
      t += length;
    }
  }
  if (!(duration - t <= shortest * duration)) return std::numeric_limits<double>::quiet_NaN();
  return std::max(std::abs(y[0] / machine.period - 1.0), std::abs(y[1] / omega_0 - 1.0));
}

}  // namespace loadpath::machine
