#include "calculators/pin/en1993.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::pin {

namespace {

using Input = En1993::Input;
using Result = En1993::Result;

template <class Tracer>
void resist(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, F_Ed, in.gamma_F * abs(in.F), "design force");
  STEP_TO(r, M_Ed, F_Ed / 8.0 * (in.t_1 + 4.0 * in.c + 2.0 * in.t_2), "figure 3.11, [EN1993-1-8]");
  STEP(A, pi / 4.0 * pow<2>(in.d), "section of the pin");
  STEP(W_el, pi / 32.0 * pow<3>(in.d), "its section modulus");
  STEP_TO(r, F_vRd, 0.6 * A * in.f_up / in.gamma_M2, "table 3.10, [EN1993-1-8]");
  STEP_TO(r, M_Rd, 1.5 * W_el * in.f_yp / in.gamma_M0, "table 3.10, [EN1993-1-8]");
  STEP_TO(r, u_v, F_Ed / 2.0 / F_vRd, "half of the force in each of two sections");
  STEP_TO(r, u_m, M_Ed / M_Rd, "bending");
  STEP_TO(r, u_vm, sqrt(pow<2>(u_m) + pow<2>(u_v)), "table 3.10 as a load factor: the root of its sum, [EN1993-1-8]");
}

/// Bearing and edge distances of both kinds of plates.
template <class Tracer>
void plates(const Input& in, Result& r, Tracer& trace) {
  const Force F_Ed = r.F_Ed;
  STEP_TO(r, F_bRd1, 1.5 * in.t_1 * in.d * min(in.f_y_1, in.f_yp) / in.gamma_M0,
          "table 3.10 with the lower strength of pin and plate, [EN1993-1-8]");
  STEP_TO(r, F_bRd2, 1.5 * in.t_2 * in.d * min(in.f_y_2, in.f_yp) / in.gamma_M0,
          "table 3.10 with the lower strength of pin and plate, [EN1993-1-8]");
  STEP_TO(r, u_b1, F_Ed / F_bRd1, "bearing of the middle plate: design force / resistance");
  STEP_TO(r, u_b2, F_Ed / 2.0 / F_bRd2, "bearing of an outer plate under half of the force");
  STEP(w_1, F_Ed * in.gamma_M0 / (2.0 * in.t_1 * in.f_y_1),
       "required width of the middle plate on each side of the bore");
  STEP(w_2, F_Ed / 2.0 * in.gamma_M0 / (2.0 * in.t_2 * in.f_y_2), "the same of an outer plate");
  STEP_TO(r, a_1, w_1 + 2.0 / 3.0 * in.d_0, "table 3.9, type A, [EN1993-1-8]");
  STEP_TO(r, c_1, w_1 + in.d_0 / 3.0, "table 3.9, type A, [EN1993-1-8]");
  STEP_TO(r, a_2, w_2 + 2.0 / 3.0 * in.d_0, "table 3.9, type A, [EN1993-1-8]");
  STEP_TO(r, c_2, w_2 + in.d_0 / 3.0, "table 3.9, type A, [EN1993-1-8]");
  if (is_set(in.e_a1)) {
    STEP_TO(r, u_a1, a_1 / in.e_a1, "end of the middle plate");
  }
  if (is_set(in.e_c1)) {
    STEP_TO(r, u_c1, c_1 / in.e_c1, "side of the middle plate");
  }
  if (is_set(in.e_a2)) {
    STEP_TO(r, u_a2, a_2 / in.e_a2, "end of an outer plate");
  }
  if (is_set(in.e_c2)) {
    STEP_TO(r, u_c2, c_2 / in.e_c2, "side of an outer plate");
  }
}

/// Additional checks of a replaceable pin, under the force without its partial factor.
template <class Tracer>
void in_service(const Input& in, Result& r, Tracer& trace) {
  STEP(F_ser, abs(in.F), "force in service");
  STEP(M_ser, F_ser / 8.0 * (in.t_1 + 4.0 * in.c + 2.0 * in.t_2), "figure 3.11, [EN1993-1-8]");
  STEP_TO(r, M_Rdser, 0.8 * pi / 32.0 * pow<3>(in.d) * in.f_yp / in.gamma_M6, "table 3.10, [EN1993-1-8]");
  STEP_TO(r, u_ms, M_ser / M_Rdser, "bending in service");
  STEP(f_1, min(in.f_y_1, in.f_yp), "lower strength of pin and middle plate");
  STEP(f_2, min(in.f_y_2, in.f_yp), "lower strength of pin and outer plate");
  STEP_TO(r, u_s1, F_ser * in.gamma_M6 / (0.6 * in.t_1 * in.d * f_1), "table 3.10, [EN1993-1-8]");
  STEP_TO(r, u_s2, F_ser / 2.0 * in.gamma_M6 / (0.6 * in.t_2 * in.d * f_2), "table 3.10, [EN1993-1-8]");
  STEP_TO(r, sigma_h1, 0.591 * sqrt(in.E * F_ser * (in.d_0 - in.d) / (pow<2>(in.d) * in.t_1)), "(3.15), [EN1993-1-8]");
  STEP_TO(r, sigma_h2, 0.591 * sqrt(in.E * F_ser / 2.0 * (in.d_0 - in.d) / (pow<2>(in.d) * in.t_2)),
          "(3.15), [EN1993-1-8]");
  STEP(f_h1, 2.5 * f_1 / in.gamma_M6, "(3.16), [EN1993-1-8]");
  STEP(f_h2, 2.5 * f_2 / in.gamma_M6, "(3.16), [EN1993-1-8]");
  STEP(k_1, sigma_h1 / f_h1, "contact stress over the one that is allowed, middle plate");
  STEP(k_2, sigma_h2 / f_h2, "the same of an outer plate");
  STEP_TO(r, u_h1, pow<2>(k_1), "force over the one that is allowed: the stress grows with its root");
  STEP_TO(r, u_h2, pow<2>(k_2), "force over the one that is allowed: the stress grows with its root");
}

}  // namespace

Applies En1993::loaded(const Input& in) { return where(abs(in.F) > 0.0 * kN.one); }

Applies En1993::replaced(const Input& in) { return std::min(where(in.replaceable == Replaceable::yes), loaded(in)); }

template <class Tracer>
En1993::Result En1993::evaluate(const Input& in, Tracer& trace) {
  Result r;
  resist(in, r, trace);
  plates(in, r, trace);
  if (is_set(in.gamma_M6)) in_service(in, r, trace);
  return r;
}

template En1993::Result En1993::evaluate(const Input&, NoTrace&);
template En1993::Result En1993::evaluate(const Input&, Trace&);

}  // namespace loadpath::pin

template const loadpath::Calculator& loadpath::erased<loadpath::pin::En1993>();
