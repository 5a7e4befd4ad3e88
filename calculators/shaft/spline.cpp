#include "calculators/shaft/spline.hpp"

#include "calculators/shaft/parts/notch_factors.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::shaft {

namespace {

using Input = Spline::Input;
using Result = Spline::Result;

template <class Tracer>
double bearing_share(const Input& in, Tracer& trace) {
  if (is_set(in.phi)) return trace.value("share", in.phi, "given");
  return trace.value("share", in.centring == Spline::Centring::inner ? 0.75 : 0.9, "by what centres it, [WelleNabe]");
}

template <class Tracer>
void stresses(const Input& in, Result& r, Tracer& trace) {
  torque_that_counts(in, r, trace);
  const Moment T_eq = r.T_eq;
  STEP_TO(r, d_m, (in.d_1 + in.d_2) / 2.0, "mean diameter of the flanks, [Bhandari-9]");
  STEP_TO(r, x_s, in.d_2 / in.d_1, "height of the teeth, up to 1.5 in ISO 14 and DIN 5480 (limit set by loadpath)");
  STEP_TO(r, h_w, (in.d_2 - in.d_1) / 2.0 - 2.0 * in.g, "of a flank, without its chamfers");
  const double share = r.share = bearing_share(in, trace);
  STEP_TO(r, F_t, 2.0 * T_eq / d_m, "at the middle of the flanks");
  STEP(p_m, F_t / (in.z * h_w * in.l * share), "mean pressure on the load-carrying flanks, [Bhandari-9]");
  STEP_TO(r, p, is_set(in.k_l) ? in.k_l * p_m : p_m, "where it is largest along them");
  if (is_set(in.b)) {
    STEP_TO(r, tau, F_t / (in.z * in.b * in.l * share) * (is_set(in.k_l) ? in.k_l : 1.0), "across a tooth");
  }
  if (!is_set(in.k_l)) {
    STEP_TO(r, x_l, in.l / d_m, "uniform pressure up to 1.3, as for keys, [DIN6892]");
  }
}

/// Against what shaft and hub allow.
template <class Tracer>
void strengths(const Input& in, Result& r, Tracer& trace) {
  const Stress p = r.p, tau = r.tau;
  const Stress p_a1 = allowed_pressure("p_a1", in.p_adm_1, in.R_e_1, trace);
  const Stress p_a2 = allowed_pressure("p_a2", in.p_adm_2, in.R_e_2, trace);
  if (is_set(p_a1)) {
    STEP_TO(r, u_1, p / p_a1, "shaft: bearing pressure / allowable pressure");
  }
  if (is_set(p_a2)) {
    STEP_TO(r, u_2, p / p_a2, "hub: bearing pressure / allowable pressure");
  }
  if (is_set(in.p_adm_w)) {
    STEP_TO(r, u_w, p / in.p_adm_w, "sliding hub: pressure / allowable pressure");
  }
  STEP_TO(r, tau_t, 16.0 / pi * r.T_eq * in.d_1 / (pow<4>(in.d_1) - pow<4>(in.d_bore)),
          "the shaft inside of its teeth");
  yielding_of_shaft(in, r, trace);
  if (!is_set(tau)) return;
  if (is_set(in.tau_adm)) {
    STEP_TO(r, u_tau, tau / in.tau_adm, "shear stress / allowable shear stress of a tooth");
  } else if (is_set(p_a1)) {
    STEP_TO(r, u_tau, sqrt(3.0) * tau / p_a1, "equivalent stress of pure shear, [Mises]");
  }
}

}  // namespace

Applies Spline::slides(const Input& in) {
  if (in.hub == Hub::unknown) return Applies::unseen;
  return where(in.hub == Hub::slides);
}

/// Where nothing is said of how uneven they bear.
Applies Spline::bears_evenly(const Input& in) { return is_set(in.k_l) ? Applies::no : torque_loads(in); }

/// A lower bound of the tensile strength of a steel from its yield strength.
Applies Spline::low_factors(const Input& in) {
  if (!is_set(in.beta_t)) return Applies::no;
  const Stress weakest = 500.0 * MPa, R_m = is_set(in.R_e_1) ? max(weakest, in.R_e_1) : weakest;
  const NotchFactors least = least_factors(Fastening::spline, R_m);
  return where(in.beta_t < least.torsion || in.beta_b < least.bending);
}

template <class Tracer>
Spline::Result Spline::evaluate(const Input& in, Tracer& trace) {
  Result r;
  stresses(in, r, trace);
  strengths(in, r, trace);
  if (is_set(in.f_W) && is_set(r.u_1) && is_set(r.u_2)) {
    STEP_TO(r, u_W, max(r.u_1, r.u_2) / in.f_W, "the worse side, by the factor of the reversal");
  }
  if (is_set(in.d_f)) {
    const Length s_N = wall_under_root(in, in.d_2, 0.0 * mm, r, trace);
    STEP_TO(r, x_R, (in.d_2 - in.d_1) / 2.0 / s_N, "wall at least as thick as the spline teeth are high");
  }
  r.connection = connection_for(Fastening::spline, in.K_A * abs(in.T), in.d_1, in.d_bore);
  r.connection.T_peak = r.T_eq, r.connection.l_c = in.l, r.connection.r_c = least_ratio(in.torque);
  r.connection.t_c = (in.d_2 - in.d_1) / 2.0;
  if (is_set(in.R_e_1)) r.connection.R_c = in.R_e_1;
  r.notch.d = in.d_1, r.notch.t = (in.d_2 - in.d_1) / 2.0;
  r.notch.beta_b = in.beta_b, r.notch.beta_t = in.beta_t;
  if (in.torque == Sense::reversing) r.notch.r_T = -1.0;
  return r;
}

template Spline::Result Spline::evaluate(const Input&, NoTrace&);
template Spline::Result Spline::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Spline>();
