// Part 3 of DIN 743 with the size factors of part 2: what the strength of a steel is in a part of this size. Recomputed
// from the formulas; the rules that two programs give differently are those of the table of the standard.
#pragma once

#include "calculators/fatigue/din743/section.hpp"
#include "calculators/fatigue/size_and_surface.hpp"

namespace loadpath::fatigue {

/// K_1 is 1 up to `from`, falls by `slope` for each tenfold of the diameter, and is `floor` from `to` on.
struct SizeLaw {
  double slope;
  Length from, to;
  double floor;
};

constexpr SizeLaw law_of_tensile_strength(SteelGroup group) {
  switch (group) {
    case SteelGroup::quenched_tempered:
    case SteelGroup::case_hardening_crnimo:
      return {0.26, from_si<Length>(0.016), from_si<Length>(0.3), 0.67};
    case SteelGroup::case_hardening:
      return {0.41, from_si<Length>(0.016), from_si<Length>(0.15), 0.60};
    default:
      return {0.23, from_si<Length>(0.1), from_si<Length>(0.3), 0.89};
  }
}

constexpr SizeLaw law_of_yield_strength(SteelGroup group) {
  if (group == SteelGroup::quenched_tempered) return {0.34, from_si<Length>(0.016), from_si<Length>(0.3), 0.57};
  if (group == SteelGroup::structural) return {0.26, from_si<Length>(0.032), from_si<Length>(0.3), 0.75};
  return law_of_tensile_strength(group);
}

template <class Tracer>
double technological_factor(const char* symbol, const SizeLaw& law, Length d_eff, Tracer& trace) {
  if (d_eff <= law.from) return trace.value(symbol, 1.0, "up to the reference diameter, [DIN743] part 2 (10)");
  if (d_eff >= law.to) return trace.value(symbol, law.floor, "it falls no further, [DIN743] part 2 (11) to (14)");
  const double c_1 = trace.value("c_1", law.slope, "of the group of steels, [DIN743] part 2 (11) to (14)");
  const Length d_1 = trace.value("d_1", law.from, "of the group of steels, [DIN743] part 2 (11) to (14)");
  return NAMED_STEP(symbol, 1.0 - c_1 * log(d_eff / d_1) / log(10.0),
                    "size at heat treatment, [DIN743] part 2 (11) to (14)");
}

/// Strengths in a part of this size.
template <class Tracer>
void strengths(const Din743Steel& s, Length d_eff, Din743Safety& r, Tracer& trace) {
  r.d_eff = d_eff;
  if (is_set(s.sigma_B)) {
    r.K_1B = technological_factor("K_1B", law_of_tensile_strength(s.group), d_eff, trace);
    r.K_1S = technological_factor("K_1S", law_of_yield_strength(s.group), d_eff, trace);
    const double K_1B = r.K_1B, K_1S = r.K_1S;
    STEP_TO(r, sigma_Bd, K_1B * s.sigma_B, "tensile strength of this size, [DIN743] part 2 section 7");
    STEP_TO(r, sigma_Sd, K_1S * s.sigma_S, "yield strength of this size, [DIN743] part 1 section 5.2");
    STEP_TO(r, x_eff, d_eff / (500.0 * mm), "K_1 is given up to 500 mm, [DIN743] part 2");
    return;
  }
  r.K_1B = trace.value("K_1B", 1.0, "R_m is that of this size");
  r.K_1S = trace.value("K_1S", 1.0, "R_e is that of this size");
  STEP_TO(r, sigma_Bd, s.R_m, "tensile strength of this size");
  STEP_TO(r, sigma_Sd, s.R_e, "yield strength of this size");
}

/// The fatigue limit of a smooth polished bar in symmetric cycles, with K_1: typed at the reference diameter, or a part
/// of the tensile strength.
template <class Tracer>
Stress smooth_limit(const Din743Steel& s, Stressing kind, const Din743Safety& strength, Tracer& trace) {
  const Stress typed = typed_of(kind, s.sigma_zdW, s.sigma_bW, s.tau_tW);
  if (is_set(typed)) {
    const double K_1B = strength.K_1B;
    const Stress sigma_W0 = trace.value("sigma_W0", typed, "of a polished bar, as given");
    return NAMED_STEP("sigma_W", K_1B * sigma_W0, "in this size, [DIN743] part 1 (5) to (7)");
  }
  const Stress sigma_Bd = strength.sigma_Bd;
  const double f_W =
      trace.value("f_W", typed_of(kind, polished_bar.tension, polished_bar.bending, polished_bar.torsion),
                  "part of the tensile strength, [DIN743] part 3");
  return NAMED_STEP("sigma_W", f_W * sigma_Bd, "of a polished bar of this size, [DIN743] part 1 (5) to (7)");
}

}  // namespace loadpath::fatigue
