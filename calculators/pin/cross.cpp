#include "calculators/pin/cross.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::pin {

namespace {

using Input = Cross::Input;
using Result = Cross::Result;

template <class Tracer>
void strength(const Input& in, Result& r, Tracer& trace) {
  const Stress tau = r.tau, p_1 = r.p_1, p_2 = r.p_2, tau_t = r.tau_t;
  const Stress tau_a = allowed_stress(
      "tau_a", in.tau_adm, in.R_m, shares_of(in.loading).shear,
      "allowable shear stress, fraction of R_m for this type of loading, [RM-9], not checked against the source",
      trace);
  if (is_set(tau_a)) {
    STEP_TO(r, u_tau, tau / tau_a, "shear of the pin: shear stress / allowable shear stress");
  }
  if (is_set(in.p_adm_1)) {
    STEP_TO(r, u_1, p_1 / in.p_adm_1, "shaft: bearing pressure / allowable pressure");
  }
  if (is_set(in.p_adm_2)) {
    STEP_TO(r, u_2, p_2 / in.p_adm_2, "hub: bearing pressure / allowable pressure");
  }
  if (is_set(in.tau_adm_1)) {
    STEP_TO(r, u_t, tau_t / in.tau_adm_1, "shaft: shear stress / allowable shear stress");
  }
}

}  // namespace

Applies Cross::loaded(const Input& in) { return where(abs(in.T) > 0.0 * N_m.one); }

Applies Cross::varies(const Input& in) { return std::min(said_to_vary(in.loading), loaded(in)); }

Applies Cross::may_vary(const Input& in) {
  return varies(in) == Applies::yes ? Applies::no : std::min(shown_by(in.K_A > 1.0), loaded(in));
}

Applies Cross::shaft_varies(const Input& in) { return varies(in) == Applies::yes ? Applies::yes : may_vary(in); }

template <class Tracer>
Cross::Result Cross::evaluate(const Input& in, Tracer& trace) {
  Result r;
  STEP_TO(r, T_d, in.K_A * abs(in.T), "with the application factor");
  STEP_TO(r, tau, 4.0 * T_d / (pi * pow<2>(in.d) * in.d_w), "two sections at the surface of the shaft, [RM-9]");
  STEP_TO(r, p_1, 6.0 * T_d / (in.d * pow<2>(in.d_w)), "growing from the axis of the shaft as in bending, [RM-9]");
  STEP(s, (in.D - in.d_w) / 2.0, "wall of the hub");
  STEP_TO(r, p_2, T_d / (in.d * s * (in.d_w + s)), "uniform over both walls, at their middle, [RM-9]");
  STEP(W_t, pi / 16.0 * pow<3>(in.d_w) - in.d * pow<2>(in.d_w) / 6.0, "shaft less its cross hole, [DIN743]");
  STEP_TO(r, tau_t, T_d / W_t, "torsion of the shaft, nominal");
  strength(in, r, trace);
  if (is_set(in.R_m) && !is_set(in.tau_adm))
    compare_with_steel(in.E, r, "the shares of R_m are those of steels", trace);
  STEP_TO(r, x_d, in.d / in.d_w, "pins of 0.2 to 0.3 of the shaft are usual, [RM-9]");
  r.connection = connection_for(Fastening::pin, T_d, in.d_w, 0.0 * mm);
  if (in.loading != Loading::unsaid)
    r.connection.r_c = in.loading == Loading::steady ? 1.0 : in.loading == Loading::pulsating ? 0.0 : -1.0;
  return r;
}

template Cross::Result Cross::evaluate(const Input&, NoTrace&);
template Cross::Result Cross::evaluate(const Input&, Trace&);

}  // namespace loadpath::pin

template const loadpath::Calculator& loadpath::erased<loadpath::pin::Cross>();
