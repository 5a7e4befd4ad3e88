#include "calculators/fatigue/combined.hpp"

#include "calculators/fatigue/tensile_strength.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::fatigue {

namespace {

using Input = Combined::Input;
using Result = Combined::Result;
using Criterion = Combined::Criterion;

/// Utilisation of each stress, and of both together by squares.
template <class Tracer>
void serensen(const Input& in, Stress sigma_t, Stress tau_t, Result& r, Tracer& trace) {
  if (!is_set(in.tau_D) || (!is_set(in.R_m) && !(is_set(in.psi_sigma) && is_set(in.psi_tau)))) return;
  if (!is_set(in.psi_sigma) && in.rule == Criterion::serensen)
    compare_with_steel(in.E, r, "psi by R_m is that of steels", trace);
  const double psi_sigma = is_set(in.psi_sigma) ? trace.value("psi_sigma", in.psi_sigma, "as given")
                                                : psi_of_steels("psi_sigma", in.R_m, trace);
  const double psi_tau =
      is_set(in.psi_tau) ? trace.value("psi_tau", in.psi_tau, "as given") : psi_in_shear("psi_tau", psi_sigma, trace);
  STEP(v_sigma, (in.sigma_a + psi_sigma / in.K_sigma * sigma_t) / in.sigma_D,
       "utilisation by normal stress, [GOST25504]");
  STEP(v_tau, (in.tau_a + psi_tau / in.K_tau * tau_t) / in.tau_D, "utilisation by shear stress, [GOST25504]");
  if (v_sigma > 0.0) {
    STEP_TO(r, n_sigma, 1.0 / v_sigma, "safety in normal stresses");
  }
  if (v_tau > 0.0) {
    STEP_TO(r, n_tau, 1.0 / v_tau, "safety in shear");
  }
  STEP_TO(r, n_Serensen, 1.0 / sqrt(pow<2>(v_sigma) + pow<2>(v_tau)),
          "n_sigma n_tau/sqrt(n_sigma^2 + n_tau^2), [GOST25504]");
}

template <class Tracer>
void mises(const Input& in, Stress sigma_t, Stress tau_t, Result& r, Tracer& trace) {
  STEP_TO(r, sigma_va, sqrt(pow<2>(in.sigma_a) + 3.0 * pow<2>(in.tau_a)), "amplitudes, [Shigley6] (6-55)");
  STEP_TO(r, sigma_vm, sqrt(pow<2>(sigma_t) + 3.0 * pow<2>(tau_t)), "means, [Shigley6] (6-56)");
  trace.value("sigma_a", sigma_va, "as one stress");
  trace.value("sigma_m", sigma_vm, "as one stress");
  const Stress S_e = trace.value("S_e", in.sigma_D, "in symmetric cycles; that in shear follows from von Mises");
  if (is_set(in.R_m)) {
    r.n_Goodman = goodman("n_Goodman", sigma_va, sigma_vm, S_e, in.R_m, "Goodman, [Shigley6] (6-46)", trace);
    r.n_Gerber = gerber("n_Gerber", sigma_va, sigma_vm, S_e, in.R_m, "Gerber, [Shigley6] (6-47)", trace);
  }
  if (!is_set(in.R_e)) return;
  r.n_Soderberg = soderberg("n_Soderberg", sigma_va, sigma_vm, S_e, in.R_e, "Soderberg, [Shigley6] (6-45)", trace);
  r.n_elliptic = elliptic("n_elliptic", sigma_va, sigma_vm, S_e, in.R_e, "ellipse of ASME, [Shigley6] (6-48)", trace);
}

template <class Tracer>
void gough(const Input& in, Stress sigma_t, Stress tau_t, Result& r, Tracer& trace) {
  if (!is_set(in.R_m) || !is_set(in.tau_D)) return;
  STEP(w_sigma, in.sigma_a / in.sigma_D + sigma_t / in.R_m, "normal stresses by Goodman");
  const Stress S_su = tensile_in_shear(in.R_m, trace);
  STEP(w_tau, in.tau_a / in.tau_D + tau_t / S_su, "shear by Goodman");
  STEP_TO(r, n_Gough, 1.0 / sqrt(pow<2>(w_sigma) + pow<2>(w_tau)), "ellipse of ductile metals, [Gough]");
}

double of(const Result& r, Criterion rule) {
  switch (rule) {
    case Criterion::serensen:
      return r.n_Serensen;
    case Criterion::goodman:
      return r.n_Goodman;
    case Criterion::soderberg:
      return r.n_Soderberg;
    case Criterion::gerber:
      return r.n_Gerber;
    case Criterion::elliptic:
      return r.n_elliptic;
    case Criterion::gough:
      return r.n_Gough;
  }
  return unset<double>;
}

template <class Tracer>
void first_cycle(const Input& in, Result& r, Tracer& trace) {
  STEP(sigma_v, sqrt(pow<2>(abs(in.sigma_m) + in.sigma_a) + 3.0 * pow<2>(abs(in.tau_m) + in.tau_a)),
       "maximum stresses at one time, [Mises]");
  if (is_set(in.R_m)) {
    STEP_TO(r, x_B, sigma_v / in.R_m, "maximum stress / tensile strength");
  }
  if (!is_set(in.R_e)) return;
  STEP_TO(r, u_y, sigma_v / in.R_e, "yielding at the first cycle");
  if (u_y > 0.0) {
    STEP_TO(r, n_y, 1.0 / u_y, "no yielding at the first load");
  }
  if (is_set(in.S_F)) {
    STEP_TO(r, u_F, in.S_F * u_y, "with its safety");
  }
}

}  // namespace

bool Combined::rule_has_all(const Input& in) { return lacking(in).path.empty(); }

FieldFault Combined::lacking(const Input& in) {
  const bool apart = in.rule == Criterion::serensen || in.rule == Criterion::gough;
  if (apart && !is_set(in.tau_D))
    return {"tau_D", say("this rule compares shear with its own fatigue limit"), say("give tau_D")};
  const bool by_yield = in.rule == Criterion::soderberg || in.rule == Criterion::elliptic;
  if (by_yield && !is_set(in.R_e))
    return {"R_e", say("this rule needs the yield strength R_e"), say("give it, or a material")};
  const bool psi = in.rule == Criterion::serensen && is_set(in.psi_sigma) && is_set(in.psi_tau);
  if (!by_yield && !psi && !is_set(in.R_m))
    return {"R_m", say("this rule needs the tensile strength R_m"),
            say("give it, or a material; Serensen does with psi_sigma and psi_tau")};
  return {};
}

template <class Tracer>
Combined::Result Combined::evaluate(const Input& in, Tracer& trace) {
  Result r;
  first_cycle(in, r, trace);
  if (!varies(in)) return r;
  compare_cycles(in, r, trace);
  STEP(sigma_t, max(in.sigma_m, 0.0 * MPa), "compressive mean stress is not credited");
  STEP(tau_t, abs(in.tau_m), "shear of either sign");
  serensen(in, sigma_t, tau_t, r, trace);
  gough(in, sigma_t, tau_t, r, trace);
  mises(in, sigma_t, tau_t, r, trace);
  r.n = trace.value("n", of(r, in.rule), "of the rule that decides");
  const bool by_mises = in.rule != Criterion::serensen && in.rule != Criterion::gough;
  if (by_mises && is_set(in.tau_D)) {
    STEP_TO(r, x_v, in.sigma_D / (sqrt(3.0) * in.tau_D), "tau_D is not below what von Mises makes of sigma_D");
  }
  STEP_TO(r, u_D, in.S_D / r.n, "required / actual safety factor");
  return r;
}

template Combined::Result Combined::evaluate(const Input&, NoTrace&);
template Combined::Result Combined::evaluate(const Input&, Trace&);

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Combined>();
