// Fatigue limits of smooth specimens from the tensile strength, by published rules, each with what it covers.
#pragma once

#include "calculators/fatigue/endurance_types.hpp"
#include "calculators/fatigue/size_and_surface.hpp"

namespace loadpath::fatigue {

/// Fatigue limit over tensile strength by a rule: a band of factors, or one factor twice.
struct Factors {
  double low = unset<double>, high = unset<double>;
  const char* why = "";
};

inline bool is_steel(EnduranceTypes::Group group) { return group <= EnduranceTypes::Group::cast_steel; }

/// The bands of [B20], for bending.
inline Factors textbook(const EnduranceTypes::Input& in) {
  using G = EnduranceTypes::Group;
  if (in.loading != EnduranceTypes::Loading::bending) return {};
  if (in.group == G::carbon_steel) return {0.40, 0.45, "carbon steel, 0.40 to 0.45 of R_m, [B20]"};
  const bool iron = in.group == G::grey_iron || in.group == G::ductile_iron || in.group == G::malleable_iron;
  if (iron) return {0.40, 0.40, "cast iron, 0.40 of R_m, [B20]"};
  if (in.group >= G::wrought_aluminium) return {0.24, 0.50, "non-ferrous metals, 0.24 to 0.50 of R_m, [B20]"};
  return {};
}

inline Factors din743(const EnduranceTypes::Input& in) {
  using L = EnduranceTypes::Loading;
  if (!is_steel(in.group) || in.group == EnduranceTypes::Group::cast_steel) return {};
  const auto& [tension, bending, torsion] = polished_bar;
  if (in.loading == L::bending) return {bending, bending, "bending, half of R_m, [DIN743]"};
  if (in.loading == L::tension) return {tension, tension, "tension and compression, 0.4 of R_m, [DIN743]"};
  return {torsion, torsion, "torsion, 0.3 of R_m, [DIN743]"};
}

/// A row of FKM: limit in tension over tensile strength, in torsion over that in tension, and how a mean stress weighs,
/// M = a_M R_m/1000 MPa + b_M.
struct FkmRow {
  EnduranceTypes::Group group;
  double sigma, tau, a_M, b_M;
};

inline const FkmRow* fkm_row(EnduranceTypes::Group group) {
  using G = EnduranceTypes::Group;
  static constexpr FkmRow rows[] = {{G::carbon_steel, 0.45, 0.577, 0.35, -0.10},
                                    {G::alloy_steel, 0.45, 0.577, 0.35, -0.10},
                                    {G::case_hardening_steel, 0.40, 0.577, 0.35, -0.10},
                                    {G::stainless_steel, 0.40, 0.577, 0.35, -0.10},
                                    {G::cast_steel, 0.34, 0.577, 0.35, 0.05},
                                    {G::grey_iron, 0.34, 1.0, 0.0, 0.5},
                                    {G::ductile_iron, 0.34, 0.65, 0.35, 0.08},
                                    {G::malleable_iron, 0.30, 0.75, 0.35, 0.13},
                                    {G::wrought_aluminium, 0.30, 0.577, 1.0, -0.04},
                                    {G::cast_aluminium, 0.30, 0.75, 1.0, 0.2}};
  for (const FkmRow& row : rows) {
    if (row.group == group) return &row;
  }
  return nullptr;
}

/// Tension; torsion is a part of it.
inline Factors fkm(const EnduranceTypes::Input& in) {
  const FkmRow* const row = fkm_row(in.group);
  if (row == nullptr || in.loading == EnduranceTypes::Loading::bending) return {};
  const bool torsion = in.loading == EnduranceTypes::Loading::torsion;
  const double factor = row->sigma * (torsion ? row->tau : 1.0);
  return {factor, factor, torsion ? "f_W,sigma f_W,tau, [FKM]" : "f_W,sigma, [FKM]"};
}

/// With the load factor of tension and torsion.
inline Factors shigley(const EnduranceTypes::Input& in) {
  using L = EnduranceTypes::Loading;
  if (!is_steel(in.group)) return {};
  if (in.loading == L::bending) return {0.5, 0.5, "rotating bending, [Shigley6] (6-8)"};
  if (in.loading == L::tension) return {0.425, 0.425, "half, times 0.85 for tension, [Shigley6] (6-8), (6-26)"};
  return {0.295, 0.295, "half, times 0.59 for torsion, [Shigley6] (6-8), (6-26)"};
}

inline Factors factors(const EnduranceTypes::Input& in) {
  using R = EnduranceTypes::RuleOf;
  switch (in.rule) {
    case R::textbook:
      return textbook(in);
    case R::din743:
      return din743(in);
    case R::fkm:
      return fkm(in);
    case R::shigley:
      return shigley(in);
  }
  return {};
}

inline bool covers(const EnduranceTypes::Input& in) { return is_set(factors(in).low); }

template <class Tracer>
void estimate(const EnduranceTypes::Input& in, EnduranceTypes::Result& r, Tracer& trace) {
  const Factors f = factors(in);
  const double f_low = trace.value("f_low", f.low, f.why);
  const double f_high = trace.value("f_high", f.high, f.why);
  // Shigley: steels stronger than 1400 MPa gain nothing; the others set no such bound.
  const Stress R_cap =
      in.rule == EnduranceTypes::RuleOf::shigley
          ? NAMED_STEP("R_cap", min(in.R_m, 1400.0 * MPa), "tensile strength that the rule counts, [Shigley6] (6-8)")
          : NAMED_STEP("R_cap", in.R_m, "tensile strength that the rule counts");
  STEP_TO(r, sigma_low, f_low * R_cap, "lower bound of the rule");
  STEP_TO(r, sigma_high, f_high * R_cap, "upper bound of the rule");
  STEP_TO(r, sigma_m1, sigma_low, "the lower bound, on the safe side");
}

}  // namespace loadpath::fatigue
