// What several calculators make of the strengths of a static test: strengths in shear, the sensitivity to mean stress
// by Serensen and by FKM, and the kpsi that American fits are published in.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::fatigue {

inline constexpr Stress kpsi = from_si<Stress>(6.894757e6);

template <class Tracer>
double in_kpsi(Stress R_m, Tracer& trace) {
  return NAMED_STEP("S_k", R_m / (6.894757 * MPa), "R_m in kpsi, in which the fit is published");
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
  return NAMED_STEP(symbol, 0.02 + 2e-4 * (R_m / MPa), "steels, [GOST25504], recalled");
}

/// The same in shear, of that in normal stresses.
template <class Tracer>
double psi_in_shear(const char* symbol, double psi, Tracer& trace) {
  const double psi_sigma = psi;
  return NAMED_STEP(symbol, 0.5 * psi_sigma, "half of it in shear, [GOST25504], recalled");
}

}  // namespace loadpath::fatigue
