// Lamé's stresses in the wall of a thick cylinder.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::vessel {

/// Lamé's constants: the radial stress is A - B/r^2, the hoop stress A + B/r^2.
struct Lame {
  Stress A = unset<Stress>;
  Force B = unset<Force>;

  [[nodiscard]] Stress hoop(Length r) const { return A + B / pow<2>(r); }
  [[nodiscard]] Stress radial(Length r) const { return A - B / pow<2>(r); }
};

/// Between the radii R_i and R_a, with the pressures p inside and p_e outside.
template <class Tracer>
Lame lame_constants(Stress p, Stress p_e, Length R_i, Length R_a, Tracer& trace) {
  STEP(A, (p * pow<2>(R_i) - p_e * pow<2>(R_a)) / (pow<2>(R_a) - pow<2>(R_i)),
       "mean of hoop and radial stress, the same at every radius, [Lame]");
  STEP(B, (p - p_e) * pow<2>(R_i * R_a) / (pow<2>(R_a) - pow<2>(R_i)),
       "their difference, half of it, times the square of the radius, [Lame]");
  return {A, B};
}

}  // namespace loadpath::vessel
