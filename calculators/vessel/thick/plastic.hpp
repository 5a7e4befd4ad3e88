// Thick cylinders of an ideally plastic material, whose axial stress lies between hoop and radial stress.
#pragma once

#include "calculators/vessel/wall.hpp"

namespace loadpath::vessel {

/// Difference of hoop and radial stress at which the wall yields.
template <class Tracer>
Stress yield_difference(Stress R_e, Hypothesis hypothesis, Tracer& trace) {
  if (hypothesis == Hypothesis::mises)
    return NAMED_STEP("Y", 2.0 / sqrt(3.0) * R_e, "von Mises, the axial stress the mean of hoop and radial stress");
  return NAMED_STEP("Y", R_e, "Tresca, the axial stress the middle one");
}

/// Pressure difference at which all of the wall yields, without hardening.
template <class Tracer>
Stress plastic_pressure(Stress Y, Length R_i, Length R_a, Tracer& trace) {
  return NAMED_STEP("p_pl", Y * log(R_a / R_i), "all of the wall yields, without hardening, [Plastic-cylinder]");
}

}  // namespace loadpath::vessel
