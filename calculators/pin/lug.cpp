#include "calculators/pin/lug.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::pin {

namespace {

using Input = Lug::Input;
using Result = Lug::Result;

/// Against typed allowable stresses, or the yield strength with its safety.
template <class Tracer>
void strength(const Input& in, Result& r, Tracer& trace) {
  const Stress sigma_n = r.sigma_n, tau_s = r.tau_s, p = r.p;
  if (is_set(in.sigma_adm)) {
    STEP_TO(r, u_n, sigma_n / in.sigma_adm, "net section stress / allowable stress");
  } else if (is_set(in.S)) {
    STEP_TO(r, u_n, in.S * sigma_n / in.R_e, "yield of the net section with its safety");
  }
  if (is_set(in.tau_adm)) {
    STEP_TO(r, u_s, tau_s / in.tau_adm, "shear-out stress / allowable shear stress");
  } else if (is_set(in.S)) {
    STEP_TO(r, u_s, in.S * sqrt(3.0) * tau_s / in.R_e, "yield in shear with its safety, [Mises]");
  }
  if (is_set(in.p_adm)) {
    STEP_TO(r, u_p, p / in.p_adm, "bearing pressure / allowable pressure");
  }
}

}  // namespace

Applies Lug::loaded(const Input& in) { return where(abs(in.F) > 0.0 * N.one); }

Applies Lug::varies(const Input& in) { return std::min(shown_by(in.K_A > 1.0), loaded(in)); }

template <class Tracer>
Lug::Result Lug::evaluate(const Input& in, Tracer& trace) {
  Result r;
  STEP_TO(r, F_d, in.K_A * abs(in.F), "with the application factor, as a tensile force");
  STEP(b_e, min(in.b, 2.5 * in.d), "width that works; table 3.9 of [EN1993-1-8] draws no wider eyes");
  STEP_TO(r, sigma_n, F_d / ((b_e - in.d) * in.t), "over both sides of the bore, [Bhandari-4]");
  STEP_TO(r, tau_s, F_d / (2.0 * in.a * in.t), "over two planes from the bore to the crown, [Bhandari-4]");
  STEP_TO(r, p, F_d / (in.d * in.t), "over the projected bore, [Bhandari-4]");
  strength(in, r, trace);
  STEP_TO(r, x_a, (b_e - in.d) / (2.0 * in.a), "a crown as thick as the sides, or thicker");
  STEP_TO(r, K_t, 2.0 + pow<3>(1.0 - in.d / b_e),
          "open hole in a strip, Heywood, not checked against the source; a loaded pin gives more");
  STEP_TO(r, r_n, in.d / 2.0, "radius of the bore");
  r.cycle = {Stresses::normal, r.sigma_n};
  return r;
}

template Lug::Result Lug::evaluate(const Input&, NoTrace&);
template Lug::Result Lug::evaluate(const Input&, Trace&);

}  // namespace loadpath::pin

template const loadpath::Calculator& loadpath::erased<loadpath::pin::Lug>();
