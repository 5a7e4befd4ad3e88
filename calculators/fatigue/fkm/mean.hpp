// Fatigue limit under a mean stress by the four fields of [FKM], for each of its four types of overloading. The limit
// falls with the mean stress in straight lines, so that where it is reached follows line by line: the least and
// largest of the lines are those of what they give.
#pragma once

#include "calculators/fatigue/fkm/section.hpp"

namespace loadpath::fatigue {

/// Least or largest stress held: along it sigma_m is sigma_c + c_A sigma_A, c_A 1 or -1.
template <class Tracer>
Stress amplitude_along(Stress held, double way, const Haigh& h, const char* why, Tracer& trace) {
  const Stress S_e = h.S_e, sigma_c = trace.value("sigma_c", held, "of the cycle, which is held");
  const double M = h.M, c_A = trace.value("c_A", way, "of the amplitude, in the mean stress that goes with it");
  return NAMED_STEP(
      "sigma_A",
      min(S_e / (1.0 - M), max(max((S_e - M * sigma_c) / (1.0 + c_A * M),
                                   (S_e * (1.0 + M / 3.0) / (1.0 + M) - M / 3.0 * sigma_c) / (1.0 + c_A * M / 3.0)),
                               S_e * (3.0 + M) / (3.0 * pow<2>(1.0 + M)))),
      why);
}

/// K_AK: the amplitude that lasts over that of symmetric cycles. The stress varies.
template <class Tracer>
double mean_stress_factor(Overload overload, FkmStress& k, Tracer& trace) {
  const Stress S_e = trace.value("S_e", k.sigma_WK, "of the section, R = −1");
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
    sigma_A = amplitude_along(sigma_m - sigma_a, 1.0, h,
                              "the minimum stress stays, F3: the fields of [FKM] 2.4 along it", trace);
  } else {
    sigma_A = amplitude_along(sigma_m + sigma_a, -1.0, h,
                              "the maximum stress stays, F4: the fields of [FKM] 2.4 along it", trace);
  }
  return NAMED_STEP("K_AK", sigma_A / S_e, "mean stress factor, [FKM] 2.4");
}

}  // namespace loadpath::fatigue
