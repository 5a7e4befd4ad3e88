#include "calculators/dynamics/angular_momentum.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::dynamics {

namespace {

using Input = AngularMomentumChange::Input;
using Part = AngularMomentumChange::Part;
using Result = AngularMomentumChange::Result;

MassMoment inertia_before(const Part& part) { return is_set(part.J_1) ? part.J_1 : part.mass * part.R_1 * part.R_1; }

MassMoment inertia_after(const Part& part) {
  if (is_set(part.J_1)) return is_set(part.J_2) ? part.J_2 : part.J_1;
  return is_set(part.R_2) ? part.mass * part.R_2 * part.R_2 : inertia_before(part);
}

AngularMomentum momentum_before(const Input& in) {
  AngularMomentum sum = 0.0 * kg_m2_per_s;
  for (const Part& part : in.parts) sum += inertia_before(part) * part.omega_1;
  return sum;
}

/// Angular momentum of the parts with given final angular velocity.
AngularMomentum momentum_known(const Input& in) {
  AngularMomentum sum = 0.0 * kg_m2_per_s;
  for (const Part& part : in.parts) {
    if (is_set(part.omega_2)) sum += inertia_after(part) * part.omega_2;
  }
  return sum;
}

MassMoment inertia_of_unknown(const Input& in) {
  MassMoment sum = 0.0 * kg_m2;
  for (const Part& part : in.parts) {
    if (!is_set(part.omega_2)) sum += inertia_after(part);
  }
  return sum;
}

template <class Tracer>
void find_speed(const Input& in, Result& r, Tracer& trace) {
  const auto J_k = r.J_k =
      trace.value("J_k", inertia_of_unknown(in), "sum of J after, of the parts whose speed is to be found");
  const Time t = r.t_M = trace.value("t", is_set(in.t) ? in.t : 0.0 * sec, "time for which the moment acts");
  STEP_TO(r, K_2, r.K_1 + in.M * t, "theorem of angular momentum, [B36]");
  STEP_TO(r, omega_2, (K_2 - r.K_k) / J_k, "angular momentum that is left for them, K = J omega, [B36]");
  r.n_2 = omega_2;
}

template <class Tracer>
void find_time(const Input& in, Result& r, Tracer& trace) {
  const auto K_2 = r.K_2 = trace.value("K_2", r.K_k, "sum of J omega after");
  if (in_si(in.M) == 0.0) return;
  STEP_TO(r, t_M, (K_2 - r.K_1) / in.M, "theorem of angular momentum, [B36]");
}

void take_energies(const Input& in, Result& r) {
  r.E_1 = r.E_2 = 0.0 * J;
  for (const Part& part : in.parts) {
    const AngularSpeed omega_2 = is_set(part.omega_2) ? part.omega_2 : r.omega_2;
    const MassMoment J_1 = inertia_before(part), J_2 = inertia_after(part);
    r.after.push_back({part.name, J_1, J_2, omega_2, omega_2});
    r.E_1 += 0.5 * J_1 * part.omega_1 * part.omega_1;
    r.E_2 += 0.5 * J_2 * omega_2 * omega_2;
  }
}

}  // namespace

bool AngularMomentumChange::has_unknown(const Input& in) {
  return std::any_of(in.parts.begin(), in.parts.end(), [](const Part& part) { return !is_set(part.omega_2); });
}

bool AngularMomentumChange::inertias_given(const Input& in) {
  return std::all_of(in.parts.begin(), in.parts.end(), [](const Part& part) {
    const bool small = is_set(part.mass) && is_set(part.R_1);
    const bool any_small = is_set(part.mass) || is_set(part.R_1) || is_set(part.R_2);
    return is_set(part.J_1) ? !any_small : small && !is_set(part.J_2);
  });
}

bool AngularMomentumChange::time_is_ahead(const Input& in) {
  if (in.parts.empty() || has_unknown(in) || !inertias_given(in)) return true;
  const double change = in_si(momentum_known(in) - momentum_before(in));
  return in_si(in.M) * change > 0.0 || (change == 0.0 && in_si(in.M) == 0.0);
}

template <class Tracer>
AngularMomentumChange::Result AngularMomentumChange::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.K_1 = trace.value("K_1", momentum_before(in), "sum of J omega before; J = m R^2 of a small mass, [B33], [B36]");
  r.K_k = momentum_known(in);
  if (has_unknown(in)) {
    trace.value("K_k", r.K_k, "sum of J omega after, of the parts whose speed is given");
    find_speed(in, r, trace);
  } else {
    find_time(in, r, trace);
  }
  take_energies(in, r);
  trace.value("E_1", r.E_1, "sum of J omega^2/2 before, [B37]");
  trace.value("E_2", r.E_2, "sum of J omega^2/2 after, [B37]");
  STEP_TO(r, Delta_E, r.E_2 - r.E_1, "brought from inside and by the moment, or lost");
  return r;
}

template AngularMomentumChange::Result AngularMomentumChange::evaluate(const Input&, NoTrace&);
template AngularMomentumChange::Result AngularMomentumChange::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::AngularMomentumChange>();
