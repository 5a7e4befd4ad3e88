#include "calculators/machine/driven_machine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace loadpath::machine {

namespace {

constexpr int law_samples = 360;

std::vector<Sample> samples_of_law(const Law& law, double period) {
  std::vector<Sample> samples;
  for (int k = 0; k < law_samples; ++k) {
    const double phi = period * k / law_samples;
    const numerics::Jet jet = law.at(phi);
    samples.push_back({phi, jet.value, jet.first});
  }
  return samples;
}

std::vector<Sample> inertia_of(const Motion::Input& in) {
  if (const Law* const law = in.J_of_phi.law()) return samples_of_law(*law, in.period);
  std::vector<Sample> samples(in.inertia_series.begin(), in.inertia_series.end());
  if (samples.empty()) return {{0.0, is_set(in.J_red) ? in_si(in.J_red) : 0.0}};
  add_slopes(samples, in.period);
  return samples;
}

/// Without the moment that accelerates the links at the constant speed n_M.
std::vector<Sample> load_of(const Motion::Input& in, const std::vector<Sample>& inertia) {
  if (const Law* const law = in.M_of_phi.law()) return samples_of_law(*law, in.period);
  if (!in.points.empty()) {
    std::vector<Sample> samples;
    for (const auto& point : in.points) samples.push_back({point.phi, in_si(point.M)});
    return samples;
  }
  std::vector<Sample> samples(in.load_series.begin(), in.load_series.end());
  if (samples.empty()) return {{0.0, is_set(in.M) ? in_si(in.M) : 0.0}};
  if (!is_set(in.n_M)) return samples;
  const double half_square = 0.5 * in_si(in.n_M) * in_si(in.n_M);
  for (Sample& sample : samples) sample.M -= half_square * slope_at(inertia, in.period, sample.phi);
  return samples;
}

MotorCurve motor_of(const Motion::Input& in, double s_K) {
  MotorCurve motor;
  if (is_set(in.n_0)) motor.omega_0 = in_si(in.n_0);
  if (!in.motor.empty()) {
    motor.kind = MotorCurve::Kind::points;
    for (const auto& point : in.motor) motor.line.push_back({in_si(point.n), in_si(point.M)});
  } else if (is_set(in.M_K)) {
    motor.kind = MotorCurve::Kind::kloss;
    motor.M_K = in_si(in.M_K), motor.s_K = s_K;
  } else {
    motor.M_A = in_si(in.M_A);
  }
  return motor;
}

figure::Plot plot_over(figure::Scale across, figure::Scale up, std::vector<figure::Curve> curves) {
  figure::Plot plot(std::move(across), std::move(up));
  plot.curves = std::move(curves);
  return plot;
}

/// At most so many points of a curve, evenly.
figure::Curve thinned(const std::vector<RunPoint>& points, double end) {
  constexpr std::size_t most = 1500;
  figure::Curve curve{"n", {0.0}, {0.0}};
  const auto last = std::find_if(points.begin(), points.end(), [&](const RunPoint& p) { return p.t > end; });
  const auto count = static_cast<std::size_t>(last - points.begin());
  const std::size_t each = count / most + 1;
  for (std::size_t k = 0; k < count; k += each) {
    curve.x.push_back(points[k].t);
    curve.y.push_back(points[k].omega);
  }
  return curve;
}

}  // namespace

DrivenMachine driven_machine(const Motion::Input& in, double s_K) {
  DrivenMachine machine{motor_of(in, s_K), in.i, in.eta, in.period, {}};
  const std::vector<Sample> inertia = inertia_of(in), load = load_of(in, inertia);
  const double constant = in_si(in.J_F) + in_si(in.J_M) * in.i * in.i;
  machine.cells = period_cells(load, inertia, constant, in.period, in.phi_0);
  return machine;
}

std::vector<figure::Figure> figures_of(const Motion::Input& in, const DrivenMachine& machine) {
  const MachineRun run = run_up(machine, true);
  if (run.end != MachineRun::End::steady) return {};
  figure::Curve n{"n", {}, {}}, M{"M", {}, {}}, drive{"motor", {}, {}}, load{"load", {}, {}};
  const auto add = [](figure::Curve& curve, double x, double y) {
    curve.x.push_back(x);
    curve.y.push_back(y);
  };
  for (std::size_t k = 0; k < machine.cells.size(); ++k) {
    const PeriodCell& cell = machine.cells[k];
    for (const double u : {0.0, 1.0}) {
      const double phi = in.phi_0 + cell.from + u * cell.width;
      add(load, phi, cell.M.at(u));
      if (u > 0.0 && k + 1 < machine.cells.size()) continue;
      const double omega = speed_of(run.cycle[u > 0.0 ? k + 1 : k].E, cell.J.at(u));
      add(n, phi, omega);
      add(M, phi, machine.motor_at(omega));
      add(drive, phi, machine.drive(omega));
    }
  }
  const figure::Scale angle{"phi", "crank angle", "deg"}, speed{"n", "speed of the crank", "rpm"};
  std::vector<figure::Figure> figures;
  figures.push_back({"speed", "Speed of the crank in the steady cycle", plot_over(angle, speed, {std::move(n)})});
  figures.push_back({"torque", "Torque of the motor in the steady cycle",
                     plot_over(angle, {"M", "torque of the motor", "N*m"}, {std::move(M)})});
  figures.push_back({"moments", "Moments of motor and load at the crank",
                     plot_over(angle, {"M", "moment at the crank", "N*m"}, {std::move(drive), std::move(load)})});
  if (std::isfinite(run.t))
    figures.push_back(
        {"run-up", "Run-up from rest", plot_over({"t", "time", "s"}, speed, {thinned(run.start, 1.2 * run.t)})});
  return figures;
}

}  // namespace loadpath::machine
