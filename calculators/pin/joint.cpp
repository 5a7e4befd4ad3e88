#include "calculators/pin/joint.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::pin {

namespace {

using Input = Joint::Input;
using Result = Joint::Result;
using Held = Joint::Held;
using Spread = Joint::Spread;

/// By how the pin is held.
template <class Tracer>
Moment largest_moment(const Input& in, Force F_d, Tracer& trace) {
  switch (in.held) {
    case Held::in_fork:
      return NAMED_STEP("M_b", F_d * (in.t_1 + 4.0 * in.c) / 8.0,
                        "supported at the faces of the clevis, [RM-9] case 2, with the gap");
    case Held::in_eye:
      return NAMED_STEP("M_b", F_d * (in.t_2 + 2.0 * in.c) / 4.0,
                        "built in at the faces of the eye, [RM-9] case 3, with the gap");
    case Held::one_side:
      return NAMED_STEP("M_b", F_d * (in.t_1 / 2.0 + in.c), "built in at the face of the wall");
    case Held::unsaid:
    case Held::loose:
      break;
  }
  if (in.spread == Spread::falling)
    return NAMED_STEP("M_b", F_d / 2.0 * (in.t_1 / 4.0 + in.c + in.t_2 / 3.0),
                      "loose, supported at a third of the cheeks, [Bhandari-4], with the gap");
  return NAMED_STEP("M_b", F_d * (in.t_1 + 4.0 * in.c + 2.0 * in.t_2) / 8.0,
                    "loose, supported in the middle of the cheeks, [RM-9] case 1, with the gap");
}

template <class Tracer>
void stresses(const Input& in, Result& r, Tracer& trace) {
  const Length d_i = trace.value("d_i", is_set(in.d_i) ? in.d_i : 0.0 * mm, "bore");
  STEP_TO(r, F_d, in.K_A * abs(in.F), "with the application factor");
  r.M_b = largest_moment(in, F_d, trace);
  const Moment M_b = r.M_b;
  STEP(W, pi / 32.0 * (pow<4>(in.d) - pow<4>(d_i)) / in.d, "section modulus of the ring");
  STEP_TO(r, sigma_b, M_b / W, "extreme fibre");
  STEP(A, pi / 4.0 * (pow<2>(in.d) - pow<2>(d_i)), "section");
  STEP(z, in.held == Held::one_side ? 1.0 : 2.0, "sections that share the force");
  STEP_TO(r, tau_m, F_d / (z * A), "mean");
  STEP_TO(r, tau, 4.0 / 3.0 * tau_m * (pow<2>(in.d) + in.d * d_i + pow<2>(d_i)) / (pow<2>(in.d) + pow<2>(d_i)),
          "neutral axis, by the first moment of half the ring");
  STEP_TO(r, sigma_v, max(sigma_b, sqrt(3.0) * tau),
          "extreme fibre or neutral axis: between them it is lower, in every section of the pin, [Mises]");
}

template <class Tracer>
void pressures(const Input& in, Result& r, Tracer& trace) {
  const Force F_d = r.F_d;
  STEP_TO(r, p_1, F_d / (in.d * in.t_1), "uniform over the projected bore of the eye");
  if (in.held == Held::one_side) {
    STEP_TO(r, p_2, F_d / (in.d * in.t_2) + 6.0 * F_d * (in.t_1 / 2.0 + in.c + in.t_2 / 2.0) / (in.d * pow<2>(in.t_2)),
            "at the face of the wall: of the force, and of its moment about the middle of the wall");
  } else {
    STEP_TO(r, p_2, F_d / (2.0 * in.d * in.t_2), "uniform over the projected bores of the cheeks");
  }
  r.eye = {r.F_d, in.d, in.t_1};
  r.cheek = {0.5 * r.F_d, in.d, in.t_2};
}

template <class Tracer>
void strength(const Input& in, Result& r, Tracer& trace) {
  const Shares shares = shares_of(in.loading);
  const Stress sigma_b = r.sigma_b, sigma_v = r.sigma_v, tau = r.tau;
  const Stress sigma_a =
      allowed_stress("sigma_a", in.sigma_adm, in.R_m, shares.bending,
                     "allowable bending stress, fraction of R_m for this type of loading, [RM-9]", trace);
  const Stress tau_a = allowed_stress(
      "tau_a", in.tau_adm, in.R_m, shares.shear,
      "allowable shear stress, fraction of R_m for this type of loading, [RM-9], not checked against the source",
      trace);
  if (is_set(sigma_a)) {
    STEP_TO(r, u_b, sigma_b / sigma_a, "bending");
    STEP_TO(r, u_v, sigma_v / sigma_a, "equivalent stress");
  }
  if (is_set(tau_a)) {
    STEP_TO(r, u_tau, tau / tau_a, "shear in the neutral axis");
  }
}

template <class Tracer>
void seats(const Input& in, Result& r, Tracer& trace) {
  const Stress p_1 = r.p_1, p_2 = r.p_2;
  if (is_set(in.p_adm_1)) {
    STEP_TO(r, u_1, p_1 / in.p_adm_1, "eye: bearing pressure / allowable pressure");
  }
  if (is_set(in.p_adm_2)) {
    STEP_TO(r, u_2, p_2 / in.p_adm_2, "clevis or wall: bearing pressure / allowable pressure");
  }
  if (!is_set(in.n)) return;
  STEP_TO(r, v, abs(in.n) * in.d / 2.0, "at the surface of the pin");
  STEP(p_s,
       in.held == Held::loose    ? max(p_1, p_2)
       : in.held == Held::in_eye ? p_2
                                 : p_1,
       "pressure of the sliding contact; for a loose pin the larger");
  STEP_TO(r, pv, p_s * v, "pressure times speed");
  if (is_set(in.pv_adm)) {
    STEP_TO(r, u_pv, pv / in.pv_adm, "pv value / allowable pv value");
  }
}

}  // namespace

Applies Joint::loaded(const Input& in) { return where(abs(in.F) > 0.0 * N.one); }

Applies Joint::varies(const Input& in) { return std::min(said_to_vary(in.loading), loaded(in)); }

Applies Joint::may_vary(const Input& in) {
  return varies(in) == Applies::yes ? Applies::no : std::min(shown_by(in.K_A > 1.0), loaded(in));
}

Applies Joint::turns_in_seat(const Input& in) {
  return is_set(in.n) ? where(abs(in.n) > 0.0 * rad_per_s.one) : Applies::unseen;
}

Applies Joint::bored(const Input& in) { return std::min(where(in.d_i > 0.0 * mm), loaded(in)); }

Applies Joint::forked(const Input& in) { return std::min(where(in.held != Held::one_side), loaded(in)); }

Applies Joint::in_wall(const Input& in) { return std::min(where(in.held == Held::one_side), loaded(in)); }

template <class Tracer>
Joint::Result Joint::evaluate(const Input& in, Tracer& trace) {
  Result r;
  stresses(in, r, trace);
  pressures(in, r, trace);
  strength(in, r, trace);
  if (is_set(in.R_m) && !(is_set(in.sigma_adm) && is_set(in.tau_adm)))
    compare_with_steel(in.E, r, "the shares of R_m are those of steels", trace);
  seats(in, r, trace);
  return r;
}

template Joint::Result Joint::evaluate(const Input&, NoTrace&);
template Joint::Result Joint::evaluate(const Input&, Trace&);

}  // namespace loadpath::pin

template const loadpath::Calculator& loadpath::erased<loadpath::pin::Joint>();
