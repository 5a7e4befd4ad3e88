// Words and fields of FKM that every calculator has which rates sections by it.
#pragma once

#include "calculators/fatigue/din743/fields.hpp"
#include "calculators/fatigue/fkm/section.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/quantity/motion_units.hpp"

namespace loadpath::fatigue {

template <class Input>
constexpr auto fkm_strength(Stress Input::*at, const char* key, const char* doc, double low, double high) {
  return Field<Input, Stress>{at, key, MPa, doc}
      .positive()
      .below(3000)
      .usually(low, high)
      .customarily_at_most(high)
      .may_be_missing();
}
/// Within these the size factor stays above zero.
template <class Input>
constexpr auto fkm_size_slope(double Input::*at, const char* key, const char* doc) {
  return Field<Input, double>{at, key, ratio, doc}.within(0, 0.6).may_be_missing();
}
template <class Input>
constexpr auto fkm_reference(Length Input::*at, const char* key, const char* doc) {
  return Field<Input, Length>{at, key, mm, doc}.within(7.5, 250).may_be_missing();
}

/// Fields of an FkmSteel.
template <class Input>
constexpr auto fkm_steel() {
  return Fields{
      Choice<Input, FkmSteelGroup>{&Input::steel, "steel", "steel group, for size, support and fatigue limit"},
      fkm_strength<Input>(&Input::R_mN, "R_mN", "tensile strength of the standard, at its reference diameter", 250,
                          most_tensile_strength),
      fkm_strength<Input>(&Input::R_eN, "R_eN", "yield strength of the standard, at its reference diameter", 150,
                          most_yield_strength),
      fkm_size_slope<Input>(&Input::a_dm, "a_dm", "slope of the size factor of R_mN, in place of the group's"),
      fkm_size_slope<Input>(&Input::a_dp, "a_dp", "size constant of R_eN; default of the group not checked"),
      fkm_reference<Input>(&Input::d_Nm, "d_Nm", "reference diameter of R_mN, in place of the group's"),
      fkm_reference<Input>(&Input::d_Np, "d_Np", "reference diameter of R_eN; default of the group not checked"),
      Field<Input, Stress>{&Input::R_m, "R_m", MPa, "tensile strength in a part of this size, in place of R_mN"}
          .positive()
          .below(3000)
          .usually(250, 2000)
          .customarily_at_most(most_tensile_strength)
          .from("material", "R_m", "d_h, D, d", "R_mN"),
      Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength in a part of this size, in place of R_eN"}
          .positive()
          .below(3000)
          .usually(150, 1800)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "d_h, D, d", "R_eN"),
      diameter_at_heat_treatment<Input>(&Input::d_h),
      Choice<Input, Fibre>{&Input::fibre, "fibre", "fibre of the rolled or forged steel, against the normal stresses"}
          .may_be_missing(),
      Field<Input, double>{&Input::K_an, "K_an", ratio, "anisotropy factor, K_A of the guideline, in place of fibre"}
          .within(0.5, 1)
          .usually(0.75, 1)
          .may_be_missing()
          .factor(),
      limit_of_bars<Input>(&Input::sigma_W, "sigma_W", "fatigue limit in tension in this size, R = −1, else by R_m"),
      limit_of_bars<Input>(&Input::tau_W, "tau_W", "fatigue limit in shear in this size, R = −1, else by R_m")};
}

template <class Input>
constexpr auto fkm_gradient(Twist Input::*at, const char* key, const char* doc) {
  return Field<Input, Twist>{at, key, per_m, doc}
      .at_least(0)
      .usually(0, 10e3)
      .customarily_at_most(10e3)
      .may_be_missing();
}
/// At least that of minor consequence, `least`.
template <class Input>
constexpr auto fkm_demand(double Input::*at, const char* key, double least, const char* doc) {
  return Field<Input, double>{at, key, ratio, doc}.at_least(1).usually(1.2, 4).customarily_at_least(least).factor();
}

/// Fields of an FkmService.
template <class Input>
constexpr auto fkm_service() {
  return Fields{
      Choice<Input, Overload>{&Input::overload, "overload", "overload case: quantity kept constant"},
      Choice<Input, Means>{&Input::means, "means", "mean stress used for a stress component"}.may_be_missing(),
      Field<Input, double>{&Input::N, "N", ratio, "required life in cycles; infinite if omitted"}
          .at_least(1)
          .usually(1e4, 1e9)
          .may_be_missing(),
      fkm_demand<Input>(&Input::j_D, "j_D", 1.2,
                        "required fatigue safety factor: 1.5, with inspections 1.35, at minor consequence 1.3, 1.2, "
                        "not checked against the guideline"),
      fkm_demand<Input>(&Input::j_m, "j_m", 1.6, "safety against fracture: 2.0 to 1.6 by consequence and by load"),
      fkm_demand<Input>(&Input::j_p, "j_p", 1.2, "safety against yielding: 1.5 to 1.2 by consequence and by load"),
      Field<Input, Stress>{&Input::R_pmax, "R_pmax", MPa,
                           "E x allowable strain: 1050 MPa is 0.5 % for steel, not checked against the source"}
          .positive()
          .usually(200, 1050)
          .customarily_at_most(1050),
      fkm_gradient<Input>(&Input::G_zd, "G_zd", "gradient over stress of alpha_zd; without it no support"),
      fkm_gradient<Input>(&Input::G_b, "G_b", "stress gradient of alpha_b, in addition to that over the diameter"),
      fkm_gradient<Input>(&Input::G_t, "G_t", "stress gradient of alpha_t, in addition to that over the diameter")};
}

/// Fields of an FkmSafety.
template <class Result>
constexpr auto fkm_results() {
  return join(
      Fields{
          Field<Result, Length>{&Result::d_eff, "d_eff", mm, "diameter at heat treatment"},
          Field<Result, double>{&Result::K_dm, "K_dm", ratio, "size at heat treatment, tensile strength"},
          Field<Result, double>{&Result::K_dp, "K_dp", ratio, "size at heat treatment, yield strength"},
          Field<Result, double>{&Result::K_an, "K_an", ratio, "anisotropy, K_A of the guideline"},
          Field<Result, Stress>{&Result::R_md, "R_md", MPa, "tensile strength of this size and direction"},
          Field<Result, Stress>{&Result::R_ed, "R_ed", MPa, "yield strength of this size and direction"},
          Field<Result, Stress>{&Result::sigma_mv, "sigma_mv", MPa, "one mean stress for all; negative: compression"},
          Field<Result, Stress>{&Result::tau_mv, "tau_mv", MPa, "the same as shear"},
          Field<Result, double>{&Result::q, "q", ratio, "0: ductile, von Mises; 1: brittle, maximum normal stress"},
          Field<Result, double>{&Result::a_NH, "a_NH", ratio, "utilisation in fatigue by the maximum normal stress"},
          Field<Result, double>{&Result::a_GH, "a_GH", ratio, "utilisation in fatigue by von Mises"},
          Field<Result, double>{&Result::S_D, "S_D", ratio,
                                "safety factor against fatigue; infinite if no stress varies"}
              .may_be_infinite(),
          Field<Result, double>{&Result::j_ges, "j_ges", ratio,
                                "safety of the static strength, against the yield limit"},
          Field<Result, double>{&Result::u_D, "u_D", ratio, "fatigue: utilisation with its safety factor, a_BK"}
              .check(),
          Field<Result, double>{&Result::u_S, "u_S", ratio, "maximum load: utilisation with its safeties, a_SK"}
              .check()
              .where_it_applies(),
          din743_range<Result>(&Result::x_eff, "x_eff",
                               "diameter at heat treatment over 250 mm, where size factors end"),
          din743_range<Result>(&Result::x_G, "x_G", "steepest gradient of the stress over 100/mm"),
          din743_range<Result>(&Result::x_Rz, "x_Rz", "roughness / 200 um (limit set by loadpath)"),
          din743_range<Result>(&Result::x_N, "x_N",
                               "1e4 cycles over N: below, lives are those of strains (limit set by loadpath)"),
          din743_range<Result>(&Result::x_small, "x_small", "7.5 mm over the diameter: measured notch factors")},
      notch_ranges<Result>(),
      Fields{ListField<Result, List<FkmStress, 3>>{&Result::stresses, "stresses",
                                                   "acting loads: tension, bending, torsion"}});
}

constexpr auto choices_of(FkmSteelGroup) {
  using G = FkmSteelGroup;
  return std::array{
      ChoiceName<G>{G::untold, "not_given", "not given: no section is assessed with it", "unstated"},
      ChoiceName<G>{G::structural, "structural", "structural steel, at 40 mm"},
      ChoiceName<G>{G::quenched_tempered, "quenched-tempered", "quenched and tempered, at 16 mm"},
      ChoiceName<G>{G::normalised, "normalised", "steel for quenching, normalised, at 16 mm"},
      ChoiceName<G>{G::case_hardening, "case-hardening", "steel for case hardening, blank hardened, at 11 mm"},
      ChoiceName<G>{G::nitriding, "nitriding", "nitriding steel, R_mN at 100 mm; type a_dp and d_Np"},
      ChoiceName<G>{G::stainless, "stainless", "stainless steel; type the constants of size"},
      ChoiceName<G>{G::forged, "forged", "other forged steel; type the constants of size"}};
}

constexpr auto choices_of(Fibre) {
  return std::array{ChoiceName<Fibre>{Fibre::along, "along", "stresses along the fibre, as of a bar"},
                    ChoiceName<Fibre>{Fibre::across, "across", "stresses across the fibre: weaker"}};
}

constexpr auto choices_of(Overload) {
  using O = Overload;
  return std::array{
      ChoiceName<O>{O::F1, "F1", "constant mean stress"}, ChoiceName<O>{O::F2, "F2", "constant stress ratio"},
      ChoiceName<O>{O::F3, "F3", "constant minimum stress"}, ChoiceName<O>{O::F4, "F4", "constant maximum stress"}};
}

constexpr auto choices_of(Means) {
  using M = Means;
  return std::array{ChoiceName<M>{M::together, "together", "one for all, by von Mises"},
                    ChoiceName<M>{M::each, "each", "its own"}};
}

}  // namespace loadpath::fatigue
