// Effect of a mean stress on a fatigue strength: the rules of the Haigh diagram, each as the equivalent fully
// reversed amplitude of a cycle, as a factor on the full load, and as the allowable amplitude at its mean stress. A
// mean stress is counted here as the caller counts it: zero or tension; only FKM includes the benefit of compression.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"

#include <array>
#include <cmath>

namespace loadpath::fatigue {

enum class MeanRule { goodman, modified_goodman, soderberg, gerber, elliptic, morrow, swt, walker, fkm, serensen };

constexpr auto choices_of(MeanRule) {
  using R = MeanRule;
  return std::array{
      ChoiceName<R>{R::goodman, "goodman", "a line to the tensile strength"},
      ChoiceName<R>{R::modified_goodman, "modified-goodman", "the same, cut off by yielding"},
      ChoiceName<R>{R::soderberg, "soderberg", "a line to the yield strength"},
      ChoiceName<R>{R::gerber, "gerber", "a parabola to the tensile strength"},
      ChoiceName<R>{R::elliptic, "elliptic", "an ellipse to the yield strength, ASME"},
      ChoiceName<R>{R::morrow, "morrow", "a line to the fatigue strength coefficient, or to the true fracture stress"},
      ChoiceName<R>{R::swt, "swt", "Smith, Watson and Topper: maximum stress times amplitude"},
      ChoiceName<R>{R::walker, "walker", "the same with an exponent of the material"},
      ChoiceName<R>{R::fkm, "fkm", "four fields of the stress ratio, FKM"},
      ChoiceName<R>{R::serensen, "serensen", "a line by psi, Serensen"}};
}

/// Constant quantity while the load grows to its limit: mean stress (case 1), ratio to the amplitude (2).
enum class MeanStress { constant, proportional };

constexpr auto choices_of(MeanStress) {
  using M = MeanStress;
  return std::array{ChoiceName<M>{M::constant, "constant", "case 1: constant mean stress"},
                    ChoiceName<M>{M::proportional, "proportional", "case 2: constant stress ratio"}};
}

/// Strengths that the rules compare a cycle with: the fully reversed strength and further material strengths; unset
/// if unknown.
struct Haigh {
  Stress S_e = unset<Stress>, R_m = unset<Stress>, R_e = unset<Stress>, sigma_f = unset<Stress>;
  double gamma = unset<double>, M = unset<double>, psi_D = unset<double>;
  double n_y = unset<double>;  // safety against yielding of this cycle
};

/// A point of the diagram.
struct Swing {
  Stress sigma_a = unset<Stress>, sigma_m = unset<Stress>;
};

/// Whether what the rule needs is known.
inline bool knows(const Haigh& h, MeanRule rule) {
  switch (rule) {
    case MeanRule::goodman:
    case MeanRule::gerber:
      return is_set(h.R_m);
    case MeanRule::modified_goodman:
      return is_set(h.R_m) && is_set(h.R_e);
    case MeanRule::soderberg:
    case MeanRule::elliptic:
      return is_set(h.R_e);
    case MeanRule::morrow:
      return is_set(h.sigma_f);
    case MeanRule::swt:
      return true;
    case MeanRule::walker:
      return is_set(h.gamma);
    case MeanRule::fkm:
      return is_set(h.M);
    case MeanRule::serensen:
      return is_set(h.psi_D);
  }
  return false;
}

/// The mean stress that leaves no amplitude; unset where the rule has none.
inline Stress largest_mean(const Haigh& h, MeanRule rule) {
  switch (rule) {
    case MeanRule::goodman:
    case MeanRule::modified_goodman:
    case MeanRule::gerber:
      return h.R_m;
    case MeanRule::soderberg:
    case MeanRule::elliptic:
      return h.R_e;
    case MeanRule::morrow:
      return h.sigma_f;
    case MeanRule::serensen:
      return h.S_e / h.psi_D;
    default:
      return unset<Stress>;
  }
}

template <class Tracer>
double goodman(const char* symbol, Stress sigma_a, Stress sigma_m, Stress S_e, Stress R_m, const char* why,
               Tracer& trace) {
  return NAMED_STEP(symbol, 1.0 / (sigma_a / S_e + sigma_m / R_m), why);
}

template <class Tracer>
double soderberg(const char* symbol, Stress sigma_a, Stress sigma_m, Stress S_e, Stress R_e, const char* why,
                 Tracer& trace) {
  return NAMED_STEP(symbol, 1.0 / (sigma_a / S_e + sigma_m / R_e), why);
}

/// Without a difference that would vanish where the mean stress does.
template <class Tracer>
double gerber(const char* symbol, Stress sigma_a, Stress sigma_m, Stress S_e, Stress R_m, const char* why,
              Tracer& trace) {
  STEP(q_m, 2.0 * sigma_m * S_e / R_m, "mean stress, as the parabola counts it");
  return NAMED_STEP(symbol, 2.0 * S_e / (sigma_a + sqrt(sigma_a * sigma_a + q_m * q_m)), why);
}

template <class Tracer>
double elliptic(const char* symbol, Stress sigma_a, Stress sigma_m, Stress S_e, Stress R_e, const char* why,
                Tracer& trace) {
  return NAMED_STEP(symbol, 1.0 / sqrt(pow<2>(sigma_a / S_e) + pow<2>(sigma_m / R_e)), why);
}

/// By the four fields of FKM, distinguished by the stress ratio.
template <class Tracer>
Stress equivalent_by_fkm(Stress sigma_a, Stress sigma_m, double M, Tracer& trace) {
  if (sigma_m <= -sigma_a) return NAMED_STEP("sigma_ar", sigma_a * (1.0 - M), "always pressed, r > 1, [FKM]");
  if (sigma_m <= sigma_a) return NAMED_STEP("sigma_ar", sigma_a + M * sigma_m, "r up to 0, [FKM]");
  if (sigma_m < 3.0 * sigma_a)
    return NAMED_STEP("sigma_ar", (1.0 + M) * (sigma_a + M / 3.0 * sigma_m) / (1.0 + M / 3.0),
                      "r from 0 to 0.5, [FKM]");
  return NAMED_STEP("sigma_ar", 3.0 * sigma_a * pow<2>(1.0 + M) / (3.0 + M), "r from 0.5 on, [FKM]");
}

/// The equivalent fully reversed amplitude; unset if the mean stress reaches the strength by itself.
template <class Tracer>
Stress equivalent(MeanRule rule, const Haigh& h, const Swing& s, Tracer& trace) {
  using std::pow;
  const auto [S_e, R_m, R_e, sigma_f, gamma, M, psi_D, n_y] = h;
  const auto [sigma_a, sigma_m] = s;
  const Stress most = largest_mean(h, rule);
  if (rule != MeanRule::serensen && is_set(most) && !(sigma_m < most)) return unset<Stress>;
  switch (rule) {
    case MeanRule::goodman:
    case MeanRule::modified_goodman:
      return NAMED_STEP("sigma_ar", sigma_a / (1.0 - sigma_m / R_m), "Goodman, [Shigley6]");
    case MeanRule::soderberg:
      return NAMED_STEP("sigma_ar", sigma_a / (1.0 - sigma_m / R_e), "Soderberg, [Shigley6]");
    case MeanRule::gerber:
      return NAMED_STEP("sigma_ar", sigma_a / (1.0 - pow<2>(sigma_m / R_m)), "Gerber, [Shigley6]");
    case MeanRule::elliptic:
      return NAMED_STEP("sigma_ar", sigma_a / sqrt(1.0 - pow<2>(sigma_m / R_e)), "ellipse of ASME, [Shigley6]");
    case MeanRule::morrow:
      return NAMED_STEP("sigma_ar", sigma_a / (1.0 - sigma_m / sigma_f), "Morrow, [Dowling9] (9.21)");
    case MeanRule::swt:
      return NAMED_STEP("sigma_ar", sqrt((sigma_m + sigma_a) * sigma_a), "Smith, Watson, Topper, [Dowling9] (9.18)");
    case MeanRule::walker:
      return NAMED_STEP("sigma_ar", (sigma_m + sigma_a) * pow(sigma_a / (sigma_m + sigma_a), gamma),
                        "Walker, [Dowling9] (9.19)");
    case MeanRule::fkm:
      return equivalent_by_fkm(sigma_a, sigma_m, M, trace);
    case MeanRule::serensen:
      return NAMED_STEP("sigma_ar", sigma_a + psi_D * sigma_m, "Serensen, [GOST25504]");
  }
  return unset<Stress>;
}

/// The allowable factor on the full load, mean stress and amplitude: `n`.
template <class Tracer>
double load_factor(MeanRule rule, const Haigh& h, const Swing& s, Stress sigma_ar, Tracer& trace) {
  const auto [S_e, R_m, R_e, sigma_f, gamma, M, psi_D, n_y] = h;
  const auto [sigma_a, sigma_m] = s;
  switch (rule) {
    case MeanRule::goodman:
      return goodman("n", sigma_a, sigma_m, S_e, R_m, "Goodman, [Shigley6] (6-46)", trace);
    case MeanRule::modified_goodman: {
      const double n_G = goodman("n_G", sigma_a, sigma_m, S_e, R_m, "Goodman, [Shigley6] (6-46)", trace);
      return NAMED_STEP("n", min(n_G, n_y), "limited by first-cycle yielding, [Shigley6] (6-49)");
    }
    case MeanRule::soderberg:
      return soderberg("n", sigma_a, sigma_m, S_e, R_e, "Soderberg, [Shigley6] (6-45)", trace);
    case MeanRule::gerber:
      return gerber("n", sigma_a, sigma_m, S_e, R_m, "Gerber, [Shigley6] (6-47)", trace);
    case MeanRule::elliptic:
      return elliptic("n", sigma_a, sigma_m, S_e, R_e, "ellipse of ASME, [Shigley6] (6-48)", trace);
    case MeanRule::morrow:
      return NAMED_STEP("n", 1.0 / (sigma_a / S_e + sigma_m / sigma_f), "Morrow: a line to sigma_f");
    default:
      return NAMED_STEP("n", S_e / sigma_ar, "sigma_ar grows with the load");
  }
}

/// The amplitude x where (sigma_m + x)^(1 - gamma) x^gamma is S_e: between bounds that hold it, halved in logarithms.
inline Stress amplitude_by_walker(const Haigh& h, Stress sigma_m) {
  const double S = in_si(h.S_e), m = in_si(sigma_m);
  double low = S * std::pow(S / (m + S), (1.0 - h.gamma) / h.gamma), high = S;
  for (int i = 0; i < 60; ++i) {
    const double x = std::sqrt(low * high);
    (std::pow(m + x, 1.0 - h.gamma) * std::pow(x, h.gamma) < S ? low : high) = x;
  }
  return from_si<Stress>(std::sqrt(low * high));
}

/// The permissible amplitude at the same mean stress: `sigma_A`, zero where there is none.
template <class Tracer>
Stress amplitude_left(MeanRule rule, const Haigh& h, Stress sigma_m, Tracer& trace) {
  const auto [S_e, R_m, R_e, sigma_f, gamma, M, psi_D, n_y] = h;
  const char* const why = "at constant mean stress";
  switch (rule) {
    case MeanRule::goodman:
      return NAMED_STEP("sigma_A", max(S_e * (1.0 - sigma_m / R_m), 0.0 * MPa), why);
    case MeanRule::modified_goodman:
      return NAMED_STEP("sigma_A", max(min(S_e * (1.0 - sigma_m / R_m), R_e - sigma_m), 0.0 * MPa), why);
    case MeanRule::soderberg:
      return NAMED_STEP("sigma_A", max(S_e * (1.0 - sigma_m / R_e), 0.0 * MPa), why);
    case MeanRule::gerber:
      return NAMED_STEP("sigma_A", S_e * max(1.0 - pow<2>(sigma_m / R_m), 0.0), why);
    case MeanRule::elliptic:
      return NAMED_STEP("sigma_A", S_e * sqrt(max(1.0 - pow<2>(sigma_m / R_e), 0.0)), why);
    case MeanRule::morrow:
      return NAMED_STEP("sigma_A", max(S_e * (1.0 - sigma_m / sigma_f), 0.0 * MPa), why);
    case MeanRule::swt:
      return NAMED_STEP("sigma_A", 2.0 * S_e * (S_e / (sigma_m + sqrt(sigma_m * sigma_m + 4.0 * S_e * S_e))), why);
    case MeanRule::walker:
      return trace.value("sigma_A", amplitude_by_walker(h, sigma_m),
                         "amplitude at which sigma_ar = S_e, constant mean stress");
    case MeanRule::fkm: {
      STEP(sigma_II, S_e - M * sigma_m, "field II of the stress ratio, R from minus infinity to 0, [FKM] 2.4");
      STEP(sigma_III, S_e * (1.0 + M / 3.0) / (1.0 + M) - M / 3.0 * sigma_m, "field III, R from 0 to 0.5, [FKM] 2.4");
      STEP(sigma_IV, S_e * (3.0 + M) / (3.0 * pow<2>(1.0 + M)), "field IV, R above 0.5, [FKM] 2.4");
      return NAMED_STEP("sigma_A", min(S_e / (1.0 - M), max(max(sigma_II, sigma_III), sigma_IV)), why);
    }
    case MeanRule::serensen:
      return NAMED_STEP("sigma_A", max(S_e - psi_D * sigma_m, 0.0 * MPa), why);
  }
  return unset<Stress>;
}

}  // namespace loadpath::fatigue
