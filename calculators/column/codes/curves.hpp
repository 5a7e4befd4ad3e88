// Critical stresses of a compressed bar over its slenderness, by every method, without safety.
//
// All take the slenderness lambda = s/i and give the mean stress F/A at which the bar fails. Where a method does not
// reach, the stress is unset.
#pragma once

#include "calculators/column/codes/choices.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::column {

/// A type of section of SP 16.13330, table 7.
struct Sp16Type {
  double alpha = unset<double>, beta = unset<double>;
};

/// Data for the curves of one bar and material; unknown values are unset.
struct Material {
  Stress E = unset<Stress>, R_e = unset<Stress>;
  Stress a_T = unset<Stress>, b_T = unset<Stress>, c_T = from_si<Stress>(0.0);
  double lambda_0 = 0.0;            // Tetmajer's formula holds from here
  double lambda_1 = unset<double>;  // Euler's formula holds from here
  double lambda_T = unset<double>;  // from Tetmajer to Euler
  Stress sigma_c = unset<Stress>;   // Rankine
  double a_R = unset<double>;       // Rankine
  Sp16Type sp16;
};

/// The smallest slenderness at which a + b lambda + c lambda^2 meets Euler's hyperbola; NaN where they do not meet.
double tetmajer_transition(const Material& material);

/// The mean stress at which the extreme fibre of an eccentric bar yields, eta = e c/i^2; of a bowed bar eta_0 = e_0
/// c/i^2. With neither it yields or buckles.
Stress secant_stress(double lambda, double eta, Stress E, Stress R_e, double eta_0 = 0.0);

template <class Tracer>
Stress euler_stress(double lambda, const Material& material, Tracer& trace) {
  const auto E = material.E;
  if (!(lambda >= material.lambda_1))
    return trace.value("sigma_cr", unset<Stress>, "below the limit slenderness Euler's formula does not hold, [B25]");
  return NAMED_STEP("sigma_cr", pow<2>(pi) * E / pow<2>(lambda), "Euler, [B25]");
}

template <class Tracer>
Stress tetmajer_stress(double lambda, const Material& material, Tracer& trace) {
  const auto &E = material.E, &R_e = material.R_e;
  const auto &a_T = material.a_T, &b_T = material.b_T, &c_T = material.c_T;
  if (!(lambda <= material.lambda_T)) {
    STEP(sigma_H, pow<2>(pi) * E / pow<2>(lambda), "above lambda_T: Euler's hyperbola");
    STEP(sigma_cr, is_set(R_e) ? min(sigma_H, R_e) : sigma_H, "never above yielding");
    return is_set(material.lambda_T) ? Stress(sigma_cr) : unset<Stress>;
  }
  if (!is_set(R_e) && lambda < material.lambda_0)
    return trace.value("sigma_cr", unset<Stress>, "below lambda_0 of the set the yield strength is needed");
  STEP(sigma_T, a_T - b_T * lambda + c_T * pow<2>(lambda), "Tetmajer-Yasinsky with the constants of the set");
  return NAMED_STEP("sigma_cr", is_set(R_e) ? min(sigma_T, R_e) : sigma_T, "never above yielding");
}

template <class Tracer>
Stress johnson_stress(double lambda, const Material& material, Tracer& trace) {
  const auto &E = material.E, &R_e = material.R_e;
  STEP(lambda_J, sqrt(2.0 * pow<2>(pi) * E / R_e),
       "here the parabola touches Euler's hyperbola, at half the yield strength");
  if (lambda <= lambda_J)
    return NAMED_STEP("sigma_cr", R_e * (1.0 - R_e * pow<2>(lambda) / (4.0 * pow<2>(pi) * E)),
                      "Johnson's parabola, [Johnson]");
  return NAMED_STEP("sigma_cr", pow<2>(pi) * E / pow<2>(lambda), "Euler, [B25]");
}

template <class Tracer>
Stress rankine_stress(double lambda, const Material& material, Tracer& trace) {
  const auto& E = material.E;
  const auto sigma_c = is_set(material.sigma_c) ? material.sigma_c : material.R_e;
  if (!is_set(material.sigma_c)) trace.value("sigma_c", sigma_c, "crushing stress: the yield strength");
  const double a_R = is_set(material.a_R) ? material.a_R
                                          : NAMED_STEP("a_R", sigma_c / (pow<2>(pi) * E),
                                                       "the constant that gives Euler for slender bars");
  return NAMED_STEP("sigma_cr", sigma_c / (1.0 + a_R * pow<2>(lambda)), "Rankine-Gordon, [Rankine]");
}

/// The reduction factor of EN 1993-1-1 with the imperfection factor of its curve.
template <class Tracer>
double ec3_reduction(double lambda, double alpha, const Material& material, Tracer& trace) {
  const auto &E = material.E, &R_e = material.R_e;
  STEP(lambda_bar, lambda / (pi * sqrt(E / R_e)), "EN 1993-1-1 (6.50), class 1 to 3, [EN1993-1-1-buckling]");
  STEP(Phi, 0.5 * (1.0 + alpha * (lambda_bar - 0.2) + pow<2>(lambda_bar)), "6.3.1.2, [EN1993-1-1-buckling]");
  return NAMED_STEP("chi", lambda_bar <= 0.2 ? 1.0 : 1.0 / (Phi + sqrt(pow<2>(Phi) - pow<2>(lambda_bar))),
                    "EN 1993-1-1 (6.49), [EN1993-1-1-buckling]");
}

template <class Tracer>
Stress aisc_stress(double lambda, const Material& material, Tracer& trace) {
  using std::pow;
  const auto &E = material.E, &R_e = material.R_e;
  STEP(F_e, pi * pi * E / (lambda * lambda), "AISC 360 (E3-4), [AISC360]");
  return NAMED_STEP("sigma_cr", lambda <= 4.71 * sqrt(E / R_e) ? pow(0.658, R_e / F_e) * R_e : 0.877 * F_e,
                    "AISC 360 (E3-2), (E3-3), [AISC360]");
}

/// Unset where the slenderness is beyond the table of the code.
template <class Tracer>
Stress sp16_stress(double lambda, const Material& material, Tracer& trace) {
  const auto &E = material.E, &R_e = material.R_e;
  const auto alpha_s = material.sp16.alpha, beta_s = material.sp16.beta;
  constexpr double end_of_table = 14.0;
  STEP(lambda_r, lambda * sqrt(R_e / E), "relative slenderness, [SP16]");
  if (!(lambda_r <= end_of_table))
    return trace.value("sigma_cr", unset<Stress>, "beyond the table of the code, which ends at 14, [SP16]");
  trace.value("alpha_s", alpha_s,
              "for the type of section, table 7, not checked against the published standard, [SP16]");
  trace.value("beta_s", beta_s, "for the type of section, table 7, not checked against the published standard, [SP16]");
  STEP(delta_s, 9.87 * (1.0 - alpha_s + beta_s * lambda_r) + pow<2>(lambda_r), "(9), [SP16]");
  STEP(phi_s, 19.74 / (delta_s + sqrt(pow<2>(delta_s) - 39.48 * pow<2>(lambda_r))),
       "(8), rearranged to avoid cancellation, [SP16]");
  STEP(phi, min(phi_s, min(1.0, 7.6 / pow<2>(lambda_r))), "within its bounds, 7.1.3, [SP16]");
  return NAMED_STEP("sigma_cr", phi * R_e, "(7) without its factors, [SP16]");
}

/// By a method that takes nothing of the bar but its slenderness; unset for one that takes more.
template <class Tracer>
Stress stress_of_slenderness(Method method, double lambda, const Material& material, Tracer& trace) {
  switch (method) {
    case Method::euler:
      return euler_stress(lambda, material, trace);
    case Method::tetmajer:
      return tetmajer_stress(lambda, material, trace);
    case Method::johnson:
      return johnson_stress(lambda, material, trace);
    case Method::rankine:
      return rankine_stress(lambda, material, trace);
    case Method::aisc:
      return aisc_stress(lambda, material, trace);
    case Method::sp16:
      return sp16_stress(lambda, material, trace);
    case Method::secant:
    case Method::ec3:
    case Method::unsaid:
      break;
  }
  return unset<Stress>;
}

}  // namespace loadpath::column
