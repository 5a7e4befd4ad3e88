// What a mean stress leaves of a fatigue limit by the four fields of [FKM], in each of its four ways to grow. The limit
// falls with the mean stress in straight lines, so that where it is reached follows line by line: the least and largest
// of the lines are those of what they give.
#pragma once

#include "calculators/fatigue/fkm/section.hpp"

namespace loadpath::fatigue {

/// Least stress held: along it sigma_m is sigma_min + sigma_A.
template <class Tracer>
Stress amplitude_above(Stress sigma_min, Stress S_e, double M, Tracer& trace) {
  return NAMED_STEP(
      "sigma_A",
      min(S_e / (1.0 - M), max(max((S_e - M * sigma_min) / (1.0 + M),
                                   (S_e * (1.0 + M / 3.0) / (1.0 + M) - M / 3.0 * sigma_min) / (1.0 + M / 3.0)),
                               S_e * (3.0 + M) / (3.0 * pow<2>(1.0 + M)))),
      "the least stress stays, F3: the fields of [FKM] 2.4 along it");
}

/// Largest stress held: along it sigma_m is sigma_hold - sigma_A.
template <class Tracer>
Stress amplitude_below(Stress sigma_hold, Stress S_e, double M, Tracer& trace) {
  return NAMED_STEP(
      "sigma_A",
      min(S_e / (1.0 - M), max(max((S_e - M * sigma_hold) / (1.0 - M),
                                   (S_e * (1.0 + M / 3.0) / (1.0 + M) - M / 3.0 * sigma_hold) / (1.0 - M / 3.0)),
                               S_e * (3.0 + M) / (3.0 * pow<2>(1.0 + M)))),
      "the largest stress stays, F4: the fields of [FKM] 2.4 along it");
}

/// K_AK: the amplitude that lasts over that of symmetric cycles. The stress varies.
template <class Tracer>
double mean_stress_factor(Overload overload, FkmStress& k, Tracer& trace) {
  const Stress S_e = trace.value("S_e", k.sigma_WK, "of the section, R = -1");
  const Stress sigma_a = k.sigma_a, sigma_m = trace.value("sigma_m", k.sigma_mv, "as the fields count it");
  const double M = k.M;
  if (overload == Overload::F2) {
    const Stress sigma_ar = equivalent_by_fkm(sigma_a, sigma_m, M, trace);
    return NAMED_STEP("K_AK", sigma_a / sigma_ar, "the stress ratio stays, F2, [FKM] 2.4");
  }
  Haigh h;
  h.S_e = S_e, h.M = M;
  Stress sigma_A = unset<Stress>;
  if (overload == Overload::F1) {
    sigma_A = amplitude_left(MeanRule::fkm, h, sigma_m, trace);
  } else if (overload == Overload::F3) {
    STEP(sigma_min, sigma_m - sigma_a, "least stress of the cycle");
    sigma_A = amplitude_above(sigma_min, S_e, M, trace);
  } else {
    STEP(sigma_hold, sigma_m + sigma_a, "largest stress of the cycle");
    sigma_A = amplitude_below(sigma_hold, S_e, M, trace);
  }
  return NAMED_STEP("K_AK", sigma_A / S_e, "mean stress factor, [FKM] 2.4");
}

}  // namespace loadpath::fatigue
