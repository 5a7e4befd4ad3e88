// The machine that the input describes.
#include "calculators/machine/motion/motion.hpp"

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

}  // namespace

DrivenMachine Motion::machine_of(const Motion::Input& in, double s_K) {
  DrivenMachine machine{motor_of(in, s_K), in.i, in.eta, in.period, {}};
  const std::vector<Sample> inertia = inertia_of(in), load = load_of(in, inertia);
  const double constant = in_si(in.J_F) + in_si(in.J_M) * in.i * in.i;
  machine.cells = period_cells(load, inertia, constant, in.period, in.phi_0);
  return machine;
}

}  // namespace loadpath::machine
