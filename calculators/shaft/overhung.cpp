#include "calculators/shaft/overhung.hpp"

#include "calculators/shaft/round_sizing.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::shaft {

namespace {

using Hypothesis = Overhung::Hypothesis;

constexpr SizingReasons by_equivalent{"bending with torsion, a solid circle", "bending with torsion, a ring",
                                      "bending with torsion: the diameter that has W_t with the given bore"};
constexpr SizingReasons by_torsion{"torsion, [B19] (4)", "torsion of a ring, [B19] (5)",
                                   "torsion: the diameter that has W_t with the given bore, [B19] (3)"};

template <class Tracer>
Length size_by_torsion(Moment M_t, Stress tau_adm, const Bore& bore, Tracer& trace) {
  STEP(W_t, M_t / tau_adm, "required section modulus for torsion only, [B19] (3)");
  return size_for_modulus("d_t", W_t, bore, by_torsion, trace);
}

/// Stresses and utilisations at the diameter.
template <class Tracer>
void check(const Overhung::Input& in, Overhung::Result& r, Tracer& trace) {
  STEP(W, pi / 32.0 * (pow<4>(r.d) - pow<4>(r.d_bore)) / r.d, "section modulus in bending");
  STEP(A, pi / 4.0 * (r.d * r.d - r.d_bore * r.d_bore), "area");
  STEP_TO(r, sigma_b, r.M_b / W, "extreme fibre");
  STEP_TO(r, tau_t, r.M_t / (2.0 * W), "surface; the modulus in torsion is twice that in bending");
  STEP_TO(r, sigma_M, sqrt(sigma_b * sigma_b + 3.0 * tau_t * tau_t), "von Mises, [Mises]");
  STEP_TO(r, sigma_T, sqrt(sigma_b * sigma_b + 4.0 * tau_t * tau_t), "Tresca");
  STEP(kappa, 4.0 / 3.0 * (r.d * r.d + r.d * r.d_bore + r.d_bore * r.d_bore) / (r.d * r.d + r.d_bore * r.d_bore),
       "shear at the neutral axis over the mean shear, from Q S / (I b) of a ring");
  STEP_TO(r, tau_Q, tau_t + kappa * in.K_A * abs(in.F) / A, "neutral axis, on the side where both act together");
  const bool mises = in.hypothesis == Hypothesis::mises;
  STEP(sigma_v, in.hypothesis == Hypothesis::mises ? sigma_M : sigma_T,
       mises ? "equivalent stress by von Mises" : "equivalent stress by Tresca");
  STEP_TO(r, u_v, sigma_v / in.sigma_adm, "bending with torsion at the extreme fibre");
  STEP(k, in.hypothesis == Hypothesis::mises ? sqrt(3.0) : 2.0,
       mises ? "root of 3 for pure shear by von Mises" : "2 for pure shear by Tresca");
  STEP_TO(r, u_Q, k * tau_Q / in.sigma_adm, "pure shear at the neutral axis");
  if (!is_set(in.tau_adm)) return;
  STEP_TO(r, u_tau, tau_t / in.tau_adm, "torsion only");
}

}  // namespace

template <class Tracer>
Overhung::Result Overhung::evaluate(const Input& in, Tracer& trace) {
  Result r;
  STEP_TO(r, M_b, in.K_A * abs(in.F) * in.a, "at the bearing");
  const Moment T = torque_of(in, trace);
  STEP_TO(r, M_t, in.K_A * abs(T), "at the same time");
  STEP(c, in.hypothesis == Hypothesis::mises ? 0.75 : 1.0,
       in.hypothesis == Hypothesis::mises ? "weight of torsion by von Mises" : "weight of torsion by Tresca");
  STEP_TO(r, M_v, sqrt(M_b * M_b + c * M_t * M_t), "equivalent moment");
  const Bore bore{in.chi, in.d_bore};
  STEP(W_t, 2.0 * M_v / in.sigma_adm, "required modulus W = M_v/sigma_adm; in torsion twice W");
  r.d_min = r.d_v = size_for_modulus("d_v", W_t, bore, by_equivalent, trace);
  if (is_set(in.tau_adm)) {
    r.d_t = size_by_torsion(M_t, in.tau_adm, bore, trace);
    STEP_TO(r, d_min, max(r.d_v, r.d_t), "the larger governs");
  }
  r.d = is_set(in.d) ? in.d : r.d_min;
  r.d_bore = bore_of(in.d_bore, in.chi, r.d);
  check(in, r, trace);
  return r;
}

template Overhung::Result Overhung::evaluate(const Input&, NoTrace&);
template Overhung::Result Overhung::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Overhung>();
