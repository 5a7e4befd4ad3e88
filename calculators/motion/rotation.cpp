#include "calculators/motion/rotation.hpp"

#include "calculators/motion/path_figures.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::motion {

namespace {

Written law_of(const Rotation::Input& in) { return {"phi", &in.phi}; }
std::array<Written, 1> laws_of(const Rotation::Input& in) { return {law_of(in)}; }

/// Counter-clockwise and accelerating are two properties: given by the signs of omega and epsilon.
Rotation::Change change_of(double omega, double epsilon, double t) {
  constexpr double rounding = 1e-12;
  if (std::abs(omega) <= rounding * std::abs(epsilon * t)) return Rotation::Change::at_rest;
  if (std::abs(epsilon * t) <= rounding * std::abs(omega)) return Rotation::Change::steady;
  return omega * epsilon > 0.0 ? Rotation::Change::faster : Rotation::Change::slower;
}

template <class Tracer>
void count_turns(const Rotation::Input& in, Rotation::Result& r, Tracer& trace) {
  const Written law = law_of(in);
  const double phi_1 = trace.angle("phi_1", motion::at(law, in_si(in.t_1)).value, "law of rotation at t_1");
  const double phi_2 = trace.angle("phi_2", motion::at(law, in_si(in.t_2)).value, "law of rotation at t_2");
  STEP_TO(r, Delta_phi, phi_2 - phi_1, "angle turned");
  STEP_TO(r, turns, Delta_phi / (2.0 * pi), "a turn is 2 pi");
  STEP_TO(r, omega_m, Delta_phi / (in.t_2 - in.t_1), "mean angular velocity, [B28]");
}

template <class Tracer>
void move_point(const Rotation::Input& in, Rotation::Result& r, Tracer& trace) {
  STEP_TO(r, v, in.R * abs(r.omega), "speed of a point on a circle, [B28]");
  STEP_TO(r, a_tau, in.R * r.epsilon, "tangential acceleration, [B28]");
  STEP_TO(r, a_n, in.R * r.omega * r.omega, "normal acceleration, [B28]");
  STEP_TO(r, a, sqrt(a_tau * a_tau + a_n * a_n), "acceleration, [B28]");
  if (in_si(a) > 0.0) r.mu = std::atan2(std::abs(in_si(a_tau)), in_si(a_n));
  const double direction = in.phi_M + r.phi_t;
  const double c = without_rounding(std::cos(direction), 1.0);
  const double s = without_rounding(std::sin(direction), 1.0);
  r.x_M = in.R * c, r.y_M = in.R * s;
  r.v_x = -in.R * r.omega * s, r.v_y = in.R * r.omega * c;
  r.a_x = -a_tau * s - a_n * c, r.a_y = a_tau * c - a_n * s;
}

}  // namespace

bool Rotation::law_reads(const Input& in) { return motion::reads(law_of(in)); }
FieldFault Rotation::law_fault(const Input& in) { return motion::reading_fault(laws_of(in)); }
bool Rotation::law_is_smooth(const Input& in) { return gap(in).message.empty(); }

FieldFault Rotation::gap(const Input& in) {
  FieldFault fault = motion::gap_fault(laws_of(in), in_si(in.t), in_si(in.t));
  if (fault.message.empty() && is_set(in.t_1) && is_set(in.t_2))
    fault = motion::gap_fault(laws_of(in), in_si(in.t_1), in_si(in.t_2));
  return fault;
}

template <class Tracer>
Rotation::Result Rotation::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const numerics::Jet now = motion::at(law_of(in), in_si(in.t));
  r.phi_t = trace.value("phi_t", now.value, "law of rotation at the time t");
  r.omega = trace.value("omega", now.first * rad_per_s, "first derivative of the law, [B28]");
  r.n = trace.value("n", r.omega, "the same in revolutions per minute");
  r.epsilon = trace.value("epsilon", now.second * rad_per_s2, "second derivative of the law, [B28]");
  r.change = change_of(now.first, now.second, in_si(in.t));
  if (is_set(in.t_1)) count_turns(in, r, trace);
  if (is_set(in.R)) move_point(in, r, trace);
  return r;
}

template Rotation::Result Rotation::evaluate(const Input&, NoTrace&);
template Rotation::Result Rotation::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Rotation::figures(const Input& in, const Result& r) {
  std::vector<figure::Figure> all;
  if (is_set(in.t_1)) {
    figure::Plot plot = over_time("omega", "angular velocity", "rad/s");
    const auto speed = [law = law_of(in)](double t) { return motion::at(law, t).first; };
    plot.curves.push_back(curve_over(in_si(in.t_1), in_si(in.t_2), 181, "omega", speed));
    if (in.t_1 <= in.t && in.t <= in.t_2) plot.marks.push_back({in_si(in.t), in_si(r.omega), "at t"});
    all.push_back({"angular-speed", "Angular speed over time", std::move(plot)});
  }
  if (!is_set(in.R)) return all;
  auto plan = plan_figure({{"Velocity of the point", "m/s", {{"v", {in_si(r.v_x), in_si(r.v_y)}}}},
                           {"Acceleration of the point", "m/s^2", {{"a", {in_si(r.a_x), in_si(r.a_y)}}}}});
  if (!std::get<figure::Plans>(plan.content).panels.empty()) all.push_back(std::move(plan));
  return all;
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::Rotation>();
