#include "calculators/shaft/set_screw.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::shaft {

namespace {

using Input = SetScrew::Input;
using Result = SetScrew::Result;

/// Holding capacity of a point over that of a cup point, [SPS].
double share_of(SetScrew::Point point) {
  using Point = SetScrew::Point;
  switch (point) {
    case Point::cup:
      return 1.0;
    case Point::cone:
      return 1.07;
    case Point::flat:
    case Point::dog:
      return 0.92;
    case Point::oval:
      return 0.90;
  }
  return unset<double>;
}

double least_safety(const Input& in) {
  const bool shaken =
      in.load_case == SetScrew::Case::dynamic || (in.load_case == SetScrew::Case::unsaid && in.K_A > 1.0);
  return shaken ? 4.0 : 1.5;
}

}  // namespace

Applies SetScrew::loaded(const Input& in) { return where(abs(in.T) > 0.0 * N_m.one || abs(in.F_a) > 0.0 * N.one); }

Applies SetScrew::twisted(const Input& in) { return torsion_of(16.0 / pi * in.K_A * abs(in.T) / (in.d * in.d * in.d)); }

template <class Tracer>
SetScrew::Result SetScrew::evaluate(const Input& in, Tracer& trace) {
  Result r;
  STEP_TO(r, F_t, 2.0 * in.K_A * abs(in.T) / in.d, "at the surface of the shaft");
  STEP_TO(r, F, sqrt(pow<2>(F_t) + pow<2>(in.K_A * in.F_a)), "around and along the shaft together");
  const double k_P = trace.value("k_P", share_of(in.point), "of the point, [SPS]");
  const double k_i = trace.value("k_i", in.i > 1 ? 2.0 * in.phi : 1.0, "of the screws");
  STEP_TO(r, F_zul, k_P * in.k_H * k_i * in.F_h, "holding capacity, [SPS]");
  STEP_TO(r, T_h, F_zul * in.d / 2.0, "without a force along the shaft");
  STEP_TO(r, u, in.S * F / F_zul, "against slip");
  const double S_min = trace.value("S_min", least_safety(in), "of this load case, [SPS]");
  STEP_TO(r, u_S, S_min / in.S, "the safety factor is not smaller");
  STEP_TO(r, tau_t, 16.0 * in.K_A * abs(in.T) / (pi * pow<3>(in.d)), "the shaft itself, without the dent");
  yielding_of_shaft(in, r, trace);
  if (is_set(in.d_s)) {
    STEP_TO(r, x_d, in.d_s / in.d, "a larger screw has no full contact on the shaft");
    STEP_TO(r, x_h, 4.0 * in.F_h / (pi * pow<2>(in.d_s) * (150.0 * MPa)),
            "upper limit of manufacturers' ratings (limit set by loadpath)");
  }
  if (is_set(in.d_f)) {
    const Length s_N = wall_under_root(in, in.d, 0.0 * mm, r, trace);
    if (is_set(in.d_s)) {
      STEP_TO(r, x_R, in.d_s / s_N, "thread length at least the screw diameter");
    }
  }
  r.connection = connection_for(Fastening::set_screw, in.K_A * abs(in.T), in.d, in.d_bore);
  r.connection.F_c = in.K_A * abs(in.F_a);
  if (in.load_case == Case::at_rest) r.connection.r_c = 1.0;
  if (is_set(in.R_e_1)) r.connection.R_c = in.R_e_1;
  return r;
}

template SetScrew::Result SetScrew::evaluate(const Input&, NoTrace&);
template SetScrew::Result SetScrew::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::SetScrew>();
