// Strength of a steel in a part of this size by [FKM]: strength with size factor and anisotropy, fatigue limit,
// sensitivity to mean stress. The constants of the size factor of the tensile strength are those of [PragTic]; those
// of the yield strength are recalled, and may be typed.
#pragma once

#include "calculators/fatigue/estimate.hpp"
#include "calculators/fatigue/fkm/section.hpp"

namespace loadpath::fatigue {

/// Slope and reference diameter of the size factors; unset where they are to be typed.
struct FkmSize {
  double a_m = unset<double>;
  Length d_m = unset<Length>;
  double a_p = unset<double>;
  Length d_p = unset<Length>;
};

constexpr FkmSize fkm_size(FkmSteelGroup group) {
  using G = FkmSteelGroup;
  constexpr Length d_11 = from_si<Length>(0.011), d_16 = from_si<Length>(0.016), d_40 = from_si<Length>(0.04);
  switch (group) {
    case G::structural:
      return {0.15, d_40, 0.30, d_40};
    case G::quenched_tempered:
      return {0.30, d_16, 0.40, d_16};
    case G::normalised:
      return {0.10, d_16, 0.20, d_16};
    case G::case_hardening:
      return {0.50, d_11, 0.50, d_11};
    case G::nitriding:
      return {0.20, from_si<Length>(0.1), unset<double>, unset<Length>};
    default:
      return {};
  }
}

/// With what is typed in place of the group's.
inline FkmSize fkm_size(const FkmSteel& s) {
  FkmSize size = fkm_size(s.steel);
  if (is_set(s.a_dm)) size.a_m = s.a_dm;
  if (is_set(s.d_Nm)) size.d_m = s.d_Nm;
  if (is_set(s.a_dp)) size.a_p = s.a_dp;
  if (is_set(s.d_Np)) size.d_p = s.d_Np;
  return size;
}

/// The row of fatigue limits and of M; forged steel has the numbers of case hardening steel.
inline const FkmRow& fkm_row(FkmSteelGroup group) {
  using G = FkmSteelGroup;
  const bool weak = group == G::case_hardening || group == G::forged;
  return *fkm_row(weak                    ? EnduranceTypes::Group::case_hardening_steel
                  : group == G::stainless ? EnduranceTypes::Group::stainless_steel
                                          : EnduranceTypes::Group::carbon_steel);
}

/// Beyond 250 mm the strength falls no further.
template <class Tracer>
double fkm_size_factor(const char* symbol, double slope, Length reference, Length d_eff, const char* source,
                       Tracer& trace) {
  if (d_eff <= reference) return trace.value(symbol, 1.0, "up to the reference diameter, [FKM] 1.2");
  const double a_d = trace.value("a_d", slope, source);
  const Length d_N = trace.value("d_N", reference, source);
  STEP(d_K, min(d_eff, 250.0 * mm), "constant from 250 mm on, not checked against the source");
  return NAMED_STEP(symbol,
                    (1.0 - 0.7686 * a_d * log(d_K / (7.5 * mm)) / log(10.0)) /
                        (1.0 - 0.7686 * a_d * log(d_N / (7.5 * mm)) / log(10.0)),
                    "size at heat treatment, [FKM] 1.2");
}

/// Rolled steel across its fibre.
inline double across_fibre(Stress R_m) {
  return R_m <= 600.0 * MPa ? 0.90 : R_m <= 900.0 * MPa ? 0.86 : R_m <= 1200.0 * MPa ? 0.83 : 0.80;
}

template <class Tracer>
double fkm_anisotropy(const FkmSteel& s, Stress R_m, Tracer& trace) {
  if (is_set(s.K_an)) return trace.value("K_an", s.K_an, "as given");
  if (s.fibre == Fibre::along) return trace.value("K_an", 1.0, "along the fibre, [FKM] 1.2");
  return trace.value("K_an", across_fibre(R_m), "across the fibre, by the tensile strength, [FKM] 1.2 in [4ming]");
}

/// Strengths in a part of this size.
template <class Tracer>
void fkm_strengths(const FkmSteel& s, FkmSafety& r, Tracer& trace) {
  const FkmSize size = fkm_size(s);
  const bool of_standard = is_set(s.R_mN);
  if (of_standard) {
    const char* const own = "as given";
    r.K_dm = fkm_size_factor("K_dm", size.a_m, size.d_m, r.d_eff,
                             is_set(s.a_dm) ? own : "of the group of steels, [FKM] in [PragTic]", trace);
    r.K_dp =
        fkm_size_factor("K_dp", size.a_p, size.d_p, r.d_eff,
                        is_set(s.a_dp) ? own : "of the group of steels, [FKM], not checked against the source", trace);
    const Length d_eff = r.d_eff;
    STEP_TO(r, x_eff, d_eff / (250.0 * mm), "size factors are given up to 250 mm, not checked against the source");
  } else {
    r.K_dm = trace.value("K_dm", 1.0, "R_m is that of this size");
    r.K_dp = trace.value("K_dp", 1.0, "R_e is that of this size");
  }
  const double K_dm = r.K_dm, K_dp = r.K_dp;
  const Stress R_m0 = trace.value("R_m0", of_standard ? s.R_mN : s.R_m, "tensile strength, as given");
  const Stress R_e0 = trace.value("R_e0", of_standard ? s.R_eN : s.R_e, "yield strength, as given");
  r.K_an = fkm_anisotropy(s, K_dm * R_m0, trace);
  const double K_an = r.K_an;
  STEP_TO(r, R_md, K_dm * K_an * R_m0, "tensile strength of this size and direction, [FKM] 1.2");
  STEP_TO(r, R_ed, K_dp * K_an * R_e0, "yield strength of this size and direction, [FKM] 1.2");
}

template <class Tracer>
double shear_over_normal(const FkmSteel& s, bool shear, Tracer& trace) {
  return trace.value("f_W", shear ? fkm_row(s.steel).tau : 1.0, "in torsion shear over normal, [FKM] 2.2");
}

/// The fatigue limit of the material in symmetric cycles of tension, or of shear. Typed values are for this size.
template <class Tracer>
Stress fkm_limit(const FkmSteel& s, bool shear, double shear_factor, Stress strength, Tracer& trace) {
  const Stress typed = shear ? s.tau_W : s.sigma_W;
  if (is_set(typed)) return trace.value("sigma_W", typed, "of polished bars, as given");
  const double f_s = trace.value("f_s", fkm_row(s.steel).sigma, "part of the tensile strength, [FKM] 2.2");
  const double f_W = shear_factor;
  const Stress R_md = strength;
  return NAMED_STEP("sigma_W", f_W * f_s * R_md, "of the material, R = −1, [FKM] 2.2");
}

template <class Tracer>
double fkm_sensitivity(const FkmSteel& s, double shear_factor, Stress strength, Tracer& trace) {
  const double a_M = trace.value("a_M", fkm_row(s.steel).a_M, "of steels, [FKM] 2.4");
  const double b_M = trace.value("b_M", fkm_row(s.steel).b_M, "of steels, [FKM] 2.4");
  const double f_W = shear_factor;
  const Stress R_md = strength;
  return NAMED_STEP("M", f_W * max(a_M * R_md / (1000.0 * MPa) + b_M, 0.0), "sensitivity to mean stress, [FKM] 2.4");
}

}  // namespace loadpath::fatigue
