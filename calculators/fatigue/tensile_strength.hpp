// Values derived from the static strengths by several calculators: strengths in shear, the sensitivity to mean stress
// by Serensen and by FKM, and the kpsi of American fits.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>

namespace loadpath::fatigue {

inline constexpr Stress kpsi = from_si<Stress>(6.894757e6);

template <class Tracer>
double in_kpsi(Stress R_m, Tracer& trace) {
  return NAMED_STEP("S_k", R_m / (6.894757 * MPa), "R_m in kpsi, in which the fit is published");
}

inline constexpr Stress fit_of_f_ends = 200.0 * kpsi;

/// Strength at 1e3 cycles over the tensile strength, of steels.
template <class Tracer>
double fraction_at_1e3(Stress R_m, Tracer& trace) {
  const double S_k = in_kpsi(R_m, trace);
  if (S_k < 70.0) return trace.value("f", 0.9, "below 70 kpsi, [Shigley6] example 6-8");
  const double S_f = trace.value("S_f", std::min(S_k, 200.0), "the fit goes from 70 to 200 kpsi");
  return NAMED_STEP("f", 1.06 - 2.8e-3 * S_f + 6.9e-6 * pow<2>(S_f),
                    "fit of the 10th edition of [Shigley6], not checked against the source");
}

template <class Tracer>
Stress tensile_in_shear(Stress R_m, Tracer& trace) {
  return NAMED_STEP("S_su", 0.67 * R_m, "strength in shear, [Shigley6] (6-54)");
}

template <class Tracer>
Stress yield_in_shear(Stress R_e, Tracer& trace) {
  return NAMED_STEP("S_sy", R_e / sqrt(3.0), "yield strength in shear, [Mises]");
}

/// Serensen's psi of steels in normal stresses.
template <class Tracer>
double psi_of_steels(const char* symbol, Stress R_m, Tracer& trace) {
  return NAMED_STEP(symbol, 0.02 + 2e-4 * (R_m / MPa), "steels, [GOST25504], not checked against the source");
}

/// The same in shear, of that in normal stresses.
template <class Tracer>
double psi_in_shear(const char* symbol, double psi, Tracer& trace) {
  const double psi_sigma = psi;
  return NAMED_STEP(symbol, 0.5 * psi_sigma, "half of it in shear, [GOST25504], not checked against the source");
}

}  // namespace loadpath::fatigue
