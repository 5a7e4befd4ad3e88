// Crown and knuckle of a torisphere under internal pressure, [EN13445-3], 7.5.3.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <cmath>

namespace loadpath::vessel {

/// Inside radii and diameter of the corroded end.
struct Torisphere {
  Length R = unset<Length>, r = unset<Length>, D = unset<Length>;

  [[nodiscard]] Length scale() const { return 0.75 * R + 0.2 * D; }
};

/// The stress factor of the knuckle: of r/D 0.06, 0.1 and 0.2, linear between them.
template <class Tracer>
double knuckle_factor(const Torisphere& end, Length e, Tracer& trace) {
  const Length R_c = end.R, r_c = end.r, D_c = end.D;
  STEP(X, r_c / D_c, "knuckle radius over diameter");
  STEP(y, e / R_c, "thickness over crown radius");
  STEP(Y, min(y, 0.04), "at most 0.04, [EN13445-3], 7.5.3");
  STEP(Z, -log(Y) / log(10.0), "Z = -lg Y, [EN13445-3], 7.5.3");
  STEP(N, 1.006 - 1.0 / (6.2 + pow<4>(90.0 * Y)), "[EN13445-3], 7.5.3");
  STEP(b_10, N * (((-0.1833 * Z + 1.0383) * Z - 1.2943) * Z + 0.837), "for X = 0.1, [EN13445-3], 7.5.3");
  if (X <= 0.1) {
    STEP(b_06, N * (((-0.3635 * Z + 2.2124) * Z - 3.2937) * Z + 1.8873), "for X = 0.06, [EN13445-3], 7.5.3");
    return NAMED_STEP("beta", 25.0 * ((0.1 - X) * b_06 + (X - 0.06) * b_10), "between X = 0.06 and 0.1");
  }
  STEP(b_20, max(0.95 * (0.56 - 1.94 * Y - 82.5 * pow<2>(Y)), 0.5), "for X = 0.2, [EN13445-3], 7.5.3");
  return NAMED_STEP("beta", 10.0 * ((0.2 - X) * b_10 + (X - 0.1) * b_20), "between X = 0.1 and 0.2");
}

/// Pressure at which the knuckle buckles plastically, allowable.
template <class Tracer>
Stress buckling_pressure(const Torisphere& end, Length e, Stress R_e, Tracer& trace) {
  using std::pow;
  const Length R_c = end.R, r_c = end.r, D_c = end.D;
  STEP(f_b, R_e / 1.5, "design stress of buckling");
  STEP(X, r_c / D_c, "knuckle radius over diameter");
  STEP(t_k, e / (0.75 * R_c + 0.2 * D_c), "slenderness of the knuckle");
  return NAMED_STEP("p_b", 111.0 * f_b * pow(t_k, 1.5) * pow(X, 0.825), "[EN13445-3], 7.5.3");
}

}  // namespace loadpath::vessel
