#include "calculators/machine/flywheel.hpp"

#include "calculators/machine/law_period.hpp"
#include "calculators/motion/laws.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/expression/resolved.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::machine {

namespace {

using Input = Flywheel::Input;
using Result = Flywheel::Result;
using Samples = Flywheel::Samples;

/// A law at even angles. The last is the end of the period, where it may leap to its start.
struct LawSamples {
  const Law& law;
  double period;
  std::size_t steps;

  [[nodiscard]] numerics::Jet jet(double phi) const {
    constexpr double before_end = 1.0 - 1e-12;
    return law.at(std::min(phi, period * before_end));
  }
  Sample operator()(std::size_t i) const {
    const double phi = period * static_cast<double>(i) / static_cast<double>(steps);
    const numerics::Jet moment = jet(phi);
    return {phi, moment.value, moment.first};
  }
  [[nodiscard]] TurningEnergy energy() const {
    return turning_energy([this](std::size_t i) { return (*this)(i); }, steps + 1, period);
  }
  /// The largest magnitude near the largest sample: that of the parabola there leads to it.
  [[nodiscard]] double peak(const TurningEnergy& sampled) const {
    const numerics::Jet at = jet(sampled.peak_phi);
    const double step = -at.first / at.second, h = period / static_cast<double>(steps);
    const double phi = sampled.peak_phi + step;
    if (!(std::abs(step) <= h) || phi < 0.0 || phi > period) return sampled.peak;
    return std::max(sampled.peak, std::abs(jet(phi).value));
  }
};

/// The energy of a law, at angles that are taken closer until it settles.
struct LawEnergy {
  TurningEnergy energy;
  bool settled = false;
};

LawEnergy energy_of(const Law& law, double period) {
  constexpr double same = 1e-5;
  constexpr std::size_t most_steps = 16 * Flywheel::most_samples;
  LawSamples samples{law, period, Flywheel::most_samples};
  LawEnergy found{samples.energy()};
  while (!found.settled && samples.steps < most_steps) {
    const TurningEnergy coarse = found.energy;
    samples.steps *= 2;
    found.energy = samples.energy();
    const double fine = found.energy.high - found.energy.low, rough = coarse.high - coarse.low;
    const double whole = found.energy.peak * period;
    found.settled = std::abs(fine - rough) <= same * fine + 1e-12 * whole &&
                    std::abs(found.energy.work - coarse.work) <= same * whole;
  }
  found.energy.peak = samples.peak(found.energy);
  return found;
}

/// Whether the samples have met every pulse of the law.
bool shows_all(const Law& law, double end, double peak) {
  constexpr double missed = 0.01;  // share of the largest moment
  const Resolved resolved = resolve(law, 0.0, end, 1e-3);
  return resolved.complete && std::all_of(resolved.corners.begin(), resolved.corners.end(), [&](const auto& corner) {
           return std::abs(corner.second) <= (1.0 + missed) * peak;
         });
}

/// The moment over one period as it is drawn, however it is given.
Samples samples_of(const Input& in) {
  if (!in.series.empty()) return in.series;
  Samples samples;
  for (const auto& point : in.points) samples.push_back({point.phi, in_si(point.M)});
  const Law* const law = in.M_of_phi.law();
  for (std::size_t i = 0; law != nullptr && i < Flywheel::most_samples; ++i) {
    const double phi = in.period * static_cast<double>(i) / Flywheel::most_samples;
    samples.push_back({phi, law->at(phi).value});
  }
  return samples;
}

TurningEnergy energy_of(const Input& in) {
  const Law* const law = in.series.empty() ? in.M_of_phi.law() : nullptr;
  if (law != nullptr) return energy_of(*law, in.period).energy;
  const Samples samples = samples_of(in);
  return turning_energy({samples.data(), samples.size()}, in.period);
}

template <class Tracer>
void take_energy(const Input& in, Result& r, Tracer& trace) {
  const TurningEnergy energy = energy_of(in);
  const Moment A = r.A = trace.value("A", energy.work * J, "integral of the moment over the period");
  STEP_TO(r, M_m, A / in.period, "mean moment: constant moment of the motor or the load, [Khurmi-16]");
  const Moment E_low = r.E_low = trace.value("E_low", energy.low * J, "minimum integral of M - M_m from the start");
  const Moment E_high = r.E_high = trace.value("E_high", energy.high * J, "maximum integral of M - M_m from the start");
  STEP_TO(r, Delta_E, E_high - E_low, "maximum fluctuation of energy, [Khurmi-16]");
  r.M_peak = energy.peak * N_m;
  const bool drives = in.role == Flywheel::Source::drive;
  r.phi_fast = drives ? energy.high_phi : energy.low_phi;
  r.phi_slow = drives ? energy.low_phi : energy.high_phi;
  const double out = drives ? energy.work : -energy.work;
  r.work = out > 0.0 ? Flywheel::Work::delivered : out < 0.0 ? Flywheel::Work::absorbed : Flywheel::Work::none;
}

/// Inertia required by delta, and delta of the given flywheel.
template <class Tracer>
void take_inertia(const Input& in, Result& r, Tracer& trace) {
  const auto given = in.inertia;
  STEP_TO(r, J_F, r.Delta_E / (in.delta * in.omega * in.omega),
          "the moment holds the links' inertia already, [Khurmi-16]");
  STEP_TO(r, J_add, max(J_F - in.J_0, 0.0 * kg_m2), "less what turns at a constant ratio");
  const MassMoment J_is = is_set(given) ? given + in.J_0 : max(J_F, in.J_0);
  trace.value("J_is", J_is, is_set(given) ? "given flywheel with J_0" : "flywheel of that inertia with J_0");
  if (!(in_si(J_is) > 0.0)) {
    r.u_delta = trace.value("u_delta", 0.0, "an even moment needs no flywheel");
    return;
  }
  STEP_TO(r, delta_is, r.Delta_E / (J_is * in.omega * in.omega), "coefficient of speed fluctuation, [Khurmi-16]");
  STEP_TO(r, n_max, in.omega * (1.0 + 0.5 * delta_is), "mean of maximum and minimum speed");
  STEP_TO(r, n_min, in.omega * (1.0 - 0.5 * delta_is), "mean of maximum and minimum speed");
  STEP_TO(r, u_delta, delta_is / in.delta, "speed fluctuation: calculated / permissible");
}

template <class Tracer>
void take_power(const Input& in, Result& r, Tracer& trace) {
  if (r.work == Flywheel::Work::none) return;
  STEP_TO(r, P_m, abs(r.M_m) * in.omega, "mean power");
  if (r.work == Flywheel::Work::absorbed) {
    STEP_TO(r, P, P_m / in.eta, "losses between the motor and this shaft");
  } else {
    STEP_TO(r, P, P_m * in.eta, "losses between this shaft and the driven machine");
  }
  if (!is_set(in.P_n)) return;
  STEP_TO(r, u_P, r.P / in.P_n, "mean power over the rated power");
}

template <class Tracer>
void take_rim(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.D)) return;
  const MassMoment J_R = trace.value("J_R", is_set(in.inertia) ? in.inertia : r.J_add, "inertia of the flywheel");
  STEP_TO(r, m_rim, 4.0 * J_R / (in.D * in.D), "all of the mass at the mean diameter of the rim");
  STEP_TO(r, v_rim, 0.5 * in.omega * in.D, "speed of the rim");
  if (!is_set(in.v_adm)) return;
  STEP_TO(r, u_v, v_rim / in.v_adm, "speed of the rim over the allowable one");
}

}  // namespace

bool Flywheel::has_one_moment(const Input& in) {
  return (is_set(in.M) ? 1 : 0) + (in.M_of_phi.empty() ? 0 : 1) + (in.points.empty() ? 0 : 1) == 1;
}

bool Flywheel::law_reads(const Input& in) { return law_fault(in).message.empty(); }

FieldFault Flywheel::law_fault(const Input& in) {
  if (in.M_of_phi.empty()) return {};
  if (const Fault* const fault = in.M_of_phi.fault()) return {"M_of_phi", fault->message, fault->hint};
  const Law* const law = in.M_of_phi.law();
  const auto moment = [&](double phi) {  // whose slope may be infinite, as at the end of a root
    const numerics::Jet jet = law->at(phi);
    return std::isfinite(jet.first) && std::isfinite(jet.second) ? jet : numerics::Jet{jet.value, 0.0, 0.0};
  };
  const double end = in.period * (1.0 - 1e-12);  // the period's end is its start
  const motion::Gap gap = motion::first_gap(moment, 0.0, end, static_cast<int>(most_samples) + 1);
  if (!gap) {
    const LawEnergy found = energy_of(*law, in.period);
    if (found.settled && shows_all(*law, end, found.energy.peak)) return {};
    return {"M_of_phi", say("the moment has too many oscillations in the period"),
            say("give the shortest period after which it repeats, or points")};
  }
  const std::string place = format_quantity(gap.from, deg.symbol, 4);
  if (gap.from < gap.to) {
    return {"M_of_phi", say("near phi = {1} the moment jumps, or varies too fast to be followed", place),
            say("it has a pole there, or too many oscillations in the period; give a jump by points")};
  }
  return {"M_of_phi", say("the moment has no value at phi = {1}", place),
          say("it divides by zero there, or takes a root or an arc function outside its range")};
}

namespace {

FieldFault leap_after(double period, double last, double first) {
  return {"M_of_phi",
          say("the moment does not repeat after {1}: it jumps there from {2} to {3}",
              format_quantity(period, deg.symbol, 5), format_quantity(last, N_m.symbol, 4),
              format_quantity(first, N_m.symbol, 4)),
          say("give the period after which it repeats, as period = \"720 deg\"; an intended jump: accept.period = "
              "\"...\"")};
}

FieldFault change_after(double period, double phi, double here, double later) {
  return {"M_of_phi",
          say("the moment does not repeat after {1}: it is {2} at {3}, and {4} a period later",
              format_quantity(period, deg.symbol, 5), format_quantity(here, N_m.symbol, 4),
              format_quantity(phi, deg.symbol, 4), format_quantity(later, N_m.symbol, 4)),
          say("give the period after which it repeats, as period = \"720 deg\"")};
}

}  // namespace

bool Flywheel::law_repeats(const Input& in) { return law_leap(in).message.empty(); }

FieldFault Flywheel::law_leap(const Input& in) {
  const Law* const law = in.M_of_phi.empty() ? nullptr : in.M_of_phi.law();
  const auto found = law == nullptr ? std::nullopt : unrepeated(*law, in.period);
  if (!found) return {};
  return found->leaps ? leap_after(in.period, found->here, found->later)
                      : change_after(in.period, found->phi, found->here, found->later);
}

bool Flywheel::points_rise(const Input& in) {
  if (in.points.empty()) return true;
  for (std::size_t i = 1; i < in.points.size(); ++i) {
    if (in.points[i].phi < in.points[i - 1].phi) return false;
  }
  const double length = in.points.back().phi - in.points.front().phi;
  return in.points.size() >= 2 && length > 0.0 && length <= in.period * (1.0 + 1e-12);
}

template <class Tracer>
Flywheel::Result Flywheel::evaluate(const Input& in, Tracer& trace) {
  Result r;
  if (is_set(in.M) && in.series.empty()) return r;  // a single moment is not a cycle: the step reports it
  take_energy(in, r, trace);
  if (is_set(in.delta)) take_inertia(in, r, trace);
  take_power(in, r, trace);
  take_rim(in, r, trace);
  return r;
}

template Flywheel::Result Flywheel::evaluate(const Input&, NoTrace&);
template Flywheel::Result Flywheel::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Flywheel::figures(const Input& in, const Result& r) {
  const Samples samples = samples_of(in);
  figure::Plot moment, energy;
  moment.x = energy.x = {"phi", "angle", "deg"};
  moment.y = {"M", "moment", "N*m"};
  energy.y = {"E", "work of the moment beyond its mean", "J"};
  figure::Curve M{"M", {}, {}}, E{"E", {}, {}, true};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    M.x.push_back(samples[i].phi);
    E.x.push_back(samples[i].phi);
    M.y.push_back(samples[i].M);
    const double work = energy_at({samples.data(), samples.size()}, in_si(r.M_m), i);
    E.y.push_back(motion::without_rounding(work, in_si(r.Delta_E)));
  }
  moment.curves.push_back(std::move(M));
  moment.bounds.push_back({in_si(r.M_m), "mean"});
  energy.curves.push_back(std::move(E));
  const bool drives = in.role == Source::drive;
  energy.marks.push_back({drives ? r.phi_fast : r.phi_slow, in_si(r.E_high), drives ? "fastest" : "slowest"});
  energy.marks.push_back({drives ? r.phi_slow : r.phi_fast, in_si(r.E_low), drives ? "slowest" : "fastest"});
  return {{"moment", "Moment over the period and its mean", std::move(moment)},
          {"energy", "Energy that the flywheel takes up and gives back", std::move(energy)}};
}

}  // namespace loadpath::machine

template const loadpath::Calculator& loadpath::erased<loadpath::machine::Flywheel>();
