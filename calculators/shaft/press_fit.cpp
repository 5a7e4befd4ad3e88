#include "calculators/shaft/press_fit.hpp"

#include "calculators/load/pressed_rings.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

using Input = PressFit::Input;
using Result = PressFit::Result;

constexpr Length none = 0.0 * mm.one;

/// Hoop stress of a rotating disc, [Lame]: at the bore of the hub and at the outside of the shaft.
constexpr const char* of_disc = "hoop stress by rotation at the fit, [Lame]";

/// Smallest and largest usable interference, cold or in service.
template <class Tracer>
void interferences(const Input& in, Result& r, Tracer& trace) {
  STEP(U_G, 0.8 * (in.Rz_1 + in.Rz_2), "pressed flat, [DIN7190]");
  const Length U_T = r.U_T = trace.value("U_T", PressFit::lost_by_heat(in), "d (alpha_2 dT_2 - alpha_1 dT_1), lost");
  STEP_TO(r, U_w_min, in.U_min - U_G - max(U_T, 0.0 * mm), "usable, cold or in service");
  STEP_TO(r, U_w_max, max(in.U_max - U_G - min(U_T, 0.0 * mm), 0.0 * mm), "usable, cold or in service");
}

/// Loss of interference by rotation: the hub expands more than the shaft.
template <class Tracer>
void growth(const Input& in, Result& r, Tracer& trace) {
  if (!PressFit::is_at_speed(in)) return;
  const Length U_w_min = r.U_w_min;
  STEP(sigma_r1, in.rho_1 * pow<2>(in.n) / 16.0 * ((3.0 + in.nu_1) * pow<2>(in.d_i) + (1.0 - in.nu_1) * pow<2>(in.d)),
       of_disc);
  STEP(sigma_r2, in.rho_2 * pow<2>(in.n) / 16.0 * ((3.0 + in.nu_2) * pow<2>(in.D) + (1.0 - in.nu_2) * pow<2>(in.d)),
       of_disc);
  STEP_TO(r, U_n, in.d * (sigma_r2 / in.E_2 - sigma_r1 / in.E_1), "loss of interference by rotation");
  STEP_TO(r, u_n, max(U_n, 0.0 * mm) / U_w_min, "relative to the interference at rest");
}

/// The pressure at which the deformation of both rings equals the interference, [Lame].
template <class Tracer>
void pressures(const Input& in, Result& r, Tracer& trace) {
  interferences(in, r, trace);
  growth(in, r, trace);
  STEP_TO(r, Q_1, in.d_i / in.d, "bore of the shaft over the fit");
  STEP_TO(r, Q_2, in.d / in.D, "fit over the outer diameter of the hub");
  const auto [K_1, K_2] = compliances_of_rings(in, Q_1, Q_2, "shaft under pressure outside, [Lame]",
                                               "hub under pressure inside, [Lame]", trace);
  const Length U_w_min = r.U_w_min, U_w_max = r.U_w_max;
  if (!is_set(r.U_n)) {
    STEP_TO(r, p_min, U_w_min / (in.d * (K_1 / in.E_1 + K_2 / in.E_2)), "minimum pressure, [Lame]");
    STEP_TO(r, p_max, U_w_max / (in.d * (K_1 / in.E_1 + K_2 / in.E_2)), "maximum pressure, [Lame]");
    return;
  }
  const Length U_n = r.U_n;
  STEP_TO(r, p_min, max(U_w_min - max(U_n, 0.0 * mm), 0.0 * mm) / (in.d * (K_1 / in.E_1 + K_2 / in.E_2)),
          "minimum pressure, at rest or at speed, [Lame]");
  STEP_TO(r, p_max, U_w_max / (in.d * (K_1 / in.E_1 + K_2 / in.E_2)), "maximum pressure at rest, [Lame]");
  STEP_TO(r, p_n, max(U_w_max - U_n, 0.0 * mm) / (in.d * (K_1 / in.E_1 + K_2 / in.E_2)),
          "maximum pressure at speed, [Lame]");
}

template <class Tracer>
void slip(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, x_l, in.l / in.d, "up to 1.5, [DIN7190], not checked against the source");
  if (is_set(in.T)) {
    const Force F_zz = trace.value("F_zz", is_set(in.F_z) ? in.F_z : 0.0 * N.one, "along the shaft");
    STEP_TO(r, F_res, in.K_A * sqrt(pow<2>(2.0 * in.T / in.d) + pow<2>(F_zz)), "around and along, as vectors");
  }
  if (!is_set(in.mu)) return;
  STEP_TO(r, F_slip, pi * in.d * in.l * in.mu * r.p_min, "friction over the fit");
  STEP_TO(r, T_slip, F_slip * in.d / 2.0, "alone");
  if (!is_set(in.S_r) || !is_set(in.T) || !(F_slip > 0.0 * N)) return;
  STEP_TO(r, u_s, in.S_r * r.F_res / F_slip, "against slip");
}

/// At rest, under the largest pressure.
template <class Tracer>
void stresses(const Input& in, Result& r, Tracer& trace) {
  const Stress p_max = r.p_max;
  const double Q_1 = r.Q_1, Q_2 = r.Q_2;
  STEP_TO(r, sigma_t2, p_max * (1.0 + pow<2>(Q_2)) / (1.0 - pow<2>(Q_2)), "at the bore of the hub, [Lame]");
  STEP_TO(r, sigma_2, sigma_t2 + p_max, "Tresca: hoop against the pressure");
  STEP_TO(
      r, sigma_1, in.d_i > 0.0 * mm ? 2.0 * p_max / (1.0 - pow<2>(Q_1)) : p_max,
      in.d_i > none ? "Tresca: hoop at the bore of a hollow shaft, [Lame]" : "Tresca: a solid shaft, pressed alike");
}

/// With speed the pressure falls and the stress by rotation rises, both with its square: the worst case is standstill
/// or full speed.
template <class Tracer>
void stresses_at_speed(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(r.U_n)) return;
  const Stress p_n = r.p_n, sigma_rest1 = trace.value("sigma_rest1", r.sigma_1, "at rest"),
               sigma_rest2 = trace.value("sigma_rest2", r.sigma_2, "at rest");
  const double Q_1 = r.Q_1, Q_2 = r.Q_2;
  STEP(sigma_n2,
       2.0 * p_n / (1.0 - pow<2>(Q_2)) +
           in.rho_2 * pow<2>(in.n) / 16.0 * ((3.0 + in.nu_2) * pow<2>(in.D) + (1.0 - in.nu_2) * pow<2>(in.d)),
       "Tresca at the bore of the hub at speed");
  STEP_TO(r, sigma_2, max(sigma_rest2, sigma_n2), "the larger one");
  STEP(sigma_n1,
       in.d_i > 0.0 * mm
           ? abs(in.rho_1 * pow<2>(in.n) / 16.0 * ((3.0 + in.nu_1) * pow<2>(in.d) + (1.0 - in.nu_1) * pow<2>(in.d_i)) -
                 2.0 * p_n / (1.0 - pow<2>(Q_1)))
           : abs(in.rho_1 * pow<2>(in.n) / 32.0 * (3.0 + in.nu_1) * pow<2>(in.d) - p_n),
       "Tresca of the shaft at speed, at its bore or its axis");
  STEP_TO(r, sigma_1, max(sigma_rest1, sigma_n1), "the larger one");
}

template <class Tracer>
void yield(const Input& in, Result& r, Tracer& trace) {
  stresses(in, r, trace);
  stresses_at_speed(in, r, trace);
  if (!is_set(in.S_F)) return;
  const Stress sigma_1 = r.sigma_1, sigma_2 = r.sigma_2;
  STEP_TO(r, u_1, in.S_F * sigma_1 / in.R_e_1, "shaft against yield");
  STEP_TO(r, u_2, in.S_F * sigma_2 / in.R_e_2, "hub against yield");
}

/// The shaft next to the hub, with the full torque.
template <class Tracer>
void torsion_of_shaft(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, tau_t, 16.0 * in.K_A * abs(in.T) * in.d / (pi * (pow<4>(in.d) - pow<4>(in.d_i))), "torsion of the ring");
  yielding_of_shaft(in, r, trace);
}

/// How it is put on: pressed, or shrunk.
template <class Tracer>
void assembly(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.mu_e)) {
    STEP_TO(r, F_e, pi * in.d * in.l * in.mu_e * r.p_max, "friction over all of the fit at the end");
    if (is_set(in.F_adm)) {
      STEP_TO(r, u_F, F_e / in.F_adm, "against the press");
    }
  }
  if (!is_set(in.U_c) || !is_set(in.alpha_2)) return;
  STEP_TO(r, dT_A, (in.U_max + in.U_c) / (in.alpha_2 * in.d), "hub wider by the interference and the clearance");
  if (!is_set(in.dT_adm)) return;
  STEP_TO(r, u_A, dT_A / in.dT_adm, "heating / allowable heating of the hub");
}

/// The speed up to which the fit is assessed: the given one, otherwise that at which 1 % of the smallest interference
/// is lost; zero without the densities.
AngularSpeed assessed_speed(const Input& in, const Result& r) {
  if (is_set(r.U_n)) return abs(in.n);
  if (!is_set(in.rho_1) || !is_set(in.rho_2)) return 0.0 * rpm.one;
  constexpr double negligible = 0.01;
  Input turning = in;
  turning.n = rpm.one;
  Result grown;
  grown.U_w_min = r.U_w_min;
  NoTrace quiet;
  growth(turning, grown, quiet);
  return grown.U_n > none ? sqrt(negligible * r.U_w_min / grown.U_n) * rpm.one : unset<AngularSpeed>;
}

}  // namespace

Length PressFit::lost_by_heat(const Input& in) {
  Length lost = none;
  if (is_set(in.dT_2) && is_set(in.alpha_2)) lost += in.d * (in.alpha_2 * in.dT_2);
  if (is_set(in.dT_1) && is_set(in.alpha_1)) lost -= in.d * (in.alpha_1 * in.dT_1);
  return lost;
}

Length PressFit::least_usable(const Input& in) {
  return in.U_min - 0.8 * (in.Rz_1 + in.Rz_2) - std::max(lost_by_heat(in), none);
}

/// Light metals expand by 19 to 27, irons and steels by 10 to 18 millionths per kelvin.
bool PressFit::expands_as_its_metal(Stress E, Density rho, Expansion alpha) {
  constexpr double millionth = 1e-6;
  if (!is_set(E) || !is_set(rho) || !is_set(alpha)) return true;
  const bool is_light = E < 80.0 * GPa && E > 40.0 * GPa && rho < 3000.0 * kg_per_m3;
  const bool is_steel = E > 180.0 * GPa && E < 230.0 * GPa && rho > 7000.0 * kg_per_m3 && rho < 8300.0 * kg_per_m3;
  const double share = alpha / per_kelvin.one / millionth;
  return !(is_light && (share < 16.0 || share > 30.0)) && !(is_steel && (share < 9.0 || share > 20.0));
}

FieldFault PressFit::nothing_left(const Input& in) {
  const auto text_of = [](Length U) { return format_quantity(in_si(U), um.symbol); };
  return {"U_min",
          say("minimum interference {1}, less {2} for roughness and {3} for heating: no usable interference remains",
              text_of(in.U_min), text_of(0.8 * (in.Rz_1 + in.Rz_2)), text_of(std::max(lost_by_heat(in), none))),
          say("take a tighter fit, or smoother surfaces")};
}

Applies PressFit::loaded(const Input& in) {
  return where(!is_set(in.T) || abs(in.T) > 0.0 * N_m.one || (is_set(in.F_z) && abs(in.F_z) > 0.0 * N.one));
}

Applies PressFit::twisted(const Input& in) {
  const Length d = in.d, b = in.d_i;
  return torsion_of(16.0 / pi * in.K_A * abs(in.T) * d / ((d - b) * (d + b) * (d * d + b * b)));
}

template <class Tracer>
PressFit::Result PressFit::evaluate(const Input& in, Tracer& trace) {
  Result r;
  pressures(in, r, trace);
  slip(in, r, trace);
  yield(in, r, trace);
  torsion_of_shaft(in, r, trace);
  assembly(in, r, trace);
  if (is_set(in.d_f)) wall_under_root(in, in.d, 0.0 * mm, r, trace);
  if (is_set(in.T)) r.connection = connection_for(Fastening::press_fit, in.K_A * abs(in.T), in.d, in.d_i);
  r.connection.l_c = in.l, r.connection.D_c = in.D, r.connection.n_c = assessed_speed(in, r);
  if (is_set(in.F_z)) r.connection.F_c = in.K_A * abs(in.F_z);
  if (is_set(in.R_e_1)) r.connection.R_c = in.R_e_1;
  return r;
}

template PressFit::Result PressFit::evaluate(const Input&, NoTrace&);
template PressFit::Result PressFit::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::PressFit>();
