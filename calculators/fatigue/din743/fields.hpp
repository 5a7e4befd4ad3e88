// Words and fields of DIN 743 that every calculator has which rates sections by it, or sections as it sees them.
#pragma once

#include "calculators/fatigue/din743/section.hpp"
#include "calculators/fatigue/size_and_surface.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/strength_bounds.hpp"

#include <array>

namespace loadpath::fatigue {

template <class Input>
constexpr auto limit_of_bars(Stress Input::*at, const char* key, const char* doc) {
  return Field<Input, Stress>{at, key, MPa, doc}.positive().usually(50, 1000).may_be_missing();
}
template <class Input>
constexpr auto notch_number(double Input::*at, const char* key, const char* doc) {
  return Field<Input, double>{at, key, ratio, doc}.within(1, 10).usually(1, 6).may_be_missing();
}
template <class Input, class Quantity>
constexpr auto action(Quantity Input::*at, const char* key, Unit<Quantity> unit, const char* doc) {
  return Field<Input, Quantity>{at, key, unit, doc}.load().may_be_missing();
}

/// Fields of a Din743Steel.
template <class Input>
constexpr auto din743_steel() {
  return Fields{
      Choice<Input, SteelGroup>{&Input::group, "group", "group of steels, which K_1 belongs to"}.may_be_missing(),
      Field<Input, Stress>{&Input::sigma_B, "sigma_B", MPa, "tensile strength at the reference diameter of the group"}
          .positive()
          .usually(250, 2000)
          .customarily_at_most(most_tensile_strength)
          .may_be_missing(),
      Field<Input, Stress>{&Input::sigma_S, "sigma_S", MPa, "yield strength at the reference diameter"}
          .positive()
          .usually(150, 1800)
          .customarily_at_most(most_yield_strength)
          .may_be_missing(),
      Field<Input, Stress>{&Input::R_m, "R_m", MPa, "tensile strength in a part of this size, in place of sigma_B"}
          .positive()
          .usually(250, 2000)
          .customarily_at_most(most_tensile_strength)
          .from("material", "R_m", "d_h, D, d", "sigma_B"),
      Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength in a part of this size, in place of sigma_S"}
          .positive()
          .usually(150, 1800)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "d_h, D, d", "sigma_S"),
      limit_of_bars<Input>(&Input::sigma_zdW, "sigma_zdW",
                           "fatigue limit of polished bars in tension, else 0.4 sigma_B"),
      limit_of_bars<Input>(&Input::sigma_bW, "sigma_bW", "fatigue limit of polished bars in bending, else 0.5 sigma_B"),
      limit_of_bars<Input>(&Input::tau_tW, "tau_tW", "fatigue limit of polished bars in torsion, else 0.3 sigma_B"),
      diameter_at_heat_treatment<Input>(&Input::d_h)};
}

/// Fields of a Din743Section.
template <class Input>
constexpr auto din743_section() {
  return Fields{
      Choice<Input, Notch>{&Input::notch, "notch", "notch type"},
      Field<Input, Length>{&Input::d, "d", mm, "diameter of the section, at the root of the notch"}
          .at_most_that_of_source("d, d_max")
          .positive()
          .usually(5, 500),
      Field<Input, Length>{&Input::d_bore, "d_bore", mm, "bore diameter"}.at_least(0),
      Field<Input, Length>{&Input::D, "D", mm, "larger diameter of a shoulder, or outer diameter of a groove"}
          .positive()
          .usually(5, 600)
          .may_be_missing(),
      Field<Input, Length>{&Input::r, "r", mm, "radius of the notch, or of the cross hole"}
          .positive()
          .usually(0.1, 100)
          .may_be_missing(),
      Field<Input, Length>{&Input::w, "w", mm, "width of a rectangular groove"}.positive().may_be_missing(),
      Field<Input, Length>{&Input::R_z, "R_z", um, "roughness at the notch"}
          .positive()
          .usually(0.5, 200)
          .may_be_missing(),
      Field<Input, double>{&Input::K_V, "K_V", ratio, "factor of a hardened, rolled or peened surface"}
          .within(1, 2)
          .usually(1, 1.8)
          .customarily_at_most(1.8)
          .factor(),
      Choice<Input, Layer>{&Input::layer, "layer", "surface layer"}.may_be_missing(),
      notch_number<Input>(&Input::alpha_zd, "alpha_zd", "shape factor in tension, net section")
          .customarily_at_least(1.1),
      notch_number<Input>(&Input::alpha_b, "alpha_b", "shape factor in bending, net section").customarily_at_least(1.1),
      notch_number<Input>(&Input::alpha_t, "alpha_t", "shape factor in torsion, net section").customarily_at_least(1.1),
      notch_number<Input>(&Input::beta_zd, "beta_zd", "notch factor in tension"),
      notch_number<Input>(&Input::beta_b, "beta_b", "notch factor in bending"),
      notch_number<Input>(&Input::beta_t, "beta_t", "notch factor in torsion"),
      Field<Input, Length>{&Input::d_BK, "d_BK", mm, "diameter of the bars used to measure beta; omitted: d"}
          .positive()
          .usually(5, 150)
          .may_be_missing(),
      Field<Input, Length>{&Input::R_zB, "R_zB", um, "roughness of these bars, else polished"}
          .positive()
          .usually(0.5, 100)
          .may_be_missing()};
}

/// Fields of SectionActions.
template <class Input>
constexpr auto section_actions() {
  return Fields{
      action<Input, Force>(&Input::F_zdm, "F_zdm", N, "mean of the axial force, tension positive").keeps_sign(),
      action<Input, Force>(&Input::F_zda, "F_zda", N, "amplitude of the axial force").at_least(0),
      action<Input, Force>(&Input::F_zdmax, "F_zdmax", N, "peak axial force"),
      action<Input, Moment>(&Input::M_bm, "M_bm", N_m, "mean of the bending moment, in axes that turn with the shaft"),
      action<Input, Moment>(&Input::M_ba, "M_ba", N_m,
                            "amplitude of the bending moment; for a rotating shaft the moment itself")
          .at_least(0),
      action<Input, Moment>(&Input::M_bmax, "M_bmax", N_m, "peak bending moment"),
      action<Input, Moment>(&Input::M_tm, "M_tm", N_m, "mean of the torque"),
      action<Input, Moment>(&Input::M_ta, "M_ta", N_m, "amplitude of the torque").at_least(0),
      action<Input, Moment>(&Input::M_tmax, "M_tmax", N_m, "peak torque"),
      action<Input, Stress>(&Input::sigma_zdm, "sigma_zdm", MPa,
                            "mean nominal stress of tension, in place of the force")
          .keeps_sign(),
      action<Input, Stress>(&Input::sigma_zda, "sigma_zda", MPa, "its amplitude").at_least(0),
      action<Input, Stress>(&Input::sigma_zdmax, "sigma_zdmax", MPa, "its maximum magnitude"),
      action<Input, Stress>(&Input::sigma_bm, "sigma_bm", MPa,
                            "mean nominal stress of bending, in place of the moment"),
      action<Input, Stress>(&Input::sigma_ba, "sigma_ba", MPa, "its amplitude").at_least(0),
      action<Input, Stress>(&Input::sigma_bmax, "sigma_bmax", MPa, "its maximum magnitude"),
      action<Input, Stress>(&Input::tau_tm, "tau_tm", MPa, "mean nominal stress of torsion, in place of the torque"),
      action<Input, Stress>(&Input::tau_ta, "tau_ta", MPa, "its amplitude").at_least(0),
      action<Input, Stress>(&Input::tau_tmax, "tau_tmax", MPa, "its maximum magnitude"),
      Field<Input, double>{&Input::f_max, "f_max", ratio,
                           "peak load factor: maximum load / (mean + amplitude) (start, jam), if no peak load is given"}
          .at_least(1)
          .usually(1, 5)
          .may_be_missing()
          .factor()};
}

/// A range that concerns some notches only.
template <class Result>
constexpr auto din743_range(double Result::*at, const char* key, const char* doc, double low = 0.0, double high = 1.0) {
  return Field<Result, double>{at, key, ratio, doc}.limit(low, high).where_it_applies();
}

/// Fields of a result with NotchRanges.
template <class Result>
constexpr auto notch_ranges() {
  return Fields{
      din743_range<Result>(&Result::x_r, "x_r", "0.03 over r/t: shape factors"),
      din743_range<Result>(&Result::x_D, "x_D", "d/D over 0.98: shape factors"),
      din743_range<Result>(&Result::x_alpha, "x_alpha", "maximum shape factor over 6"),
      din743_range<Result>(&Result::x_t, "x_t", "depth of a V-groove over the diameter", 0.05, 0.2),
      din743_range<Result>(&Result::x_hole, "x_hole", "cross hole / diameter (limit set by loadpath)", 0.0, 0.3),
      din743_range<Result>(&Result::x_bore, "x_bore", "bore over the diameter: notch factors are of solid shafts", 0.0,
                           1e-9)};
}

/// Fields of a Din743Safety.
template <class Result>
constexpr auto din743_results() {
  return join(
      Fields{Field<Result, Length>{&Result::d_eff, "d_eff", mm, "diameter at heat treatment"},
             Field<Result, double>{&Result::K_1B, "K_1B", ratio, "size at heat treatment, tensile strength"},
             Field<Result, double>{&Result::K_1S, "K_1S", ratio, "size at heat treatment, yield strength"},
             Field<Result, Stress>{&Result::sigma_Bd, "sigma_Bd", MPa, "tensile strength of this size"},
             Field<Result, Stress>{&Result::sigma_Sd, "sigma_Sd", MPa, "yield strength of this size"},
             Field<Result, Stress>{&Result::sigma_mv, "sigma_mv", MPa, "equivalent mean stress; negative: compression"},
             Field<Result, Stress>{&Result::tau_mv, "tau_mv", MPa, "equivalent mean stress of shear"},
             Field<Result, double>{&Result::S_D, "S_D", ratio,
                                   "safety factor against fatigue; infinite if no stress varies"}
                 .may_be_infinite(),
             Field<Result, double>{&Result::S_F, "S_F", ratio, "required safety factor against yielding at peak load"}
                 .may_be_infinite(),
             Field<Result, double>{&Result::u_D, "u_D", ratio, "fatigue: required safety over S_D"}.check(),
             Field<Result, double>{&Result::u_F, "u_F", ratio, "yielding: required safety over S_F"}
                 .check()
                 .where_it_applies(),
             din743_range<Result>(&Result::x_m, "x_m", "equivalent mean stress over the yield limit").criterion(),
             din743_range<Result>(&Result::x_small, "x_small", "7.5 mm / diameter: K_2 and K_3 are given from 7.5 mm"),
             din743_range<Result>(&Result::x_eff, "x_eff", "diameter at heat treatment over 500 mm, where K_1 ends"),
             din743_range<Result>(&Result::x_Rz, "x_Rz", "roughness / 200 um (limit set by loadpath)")},
      notch_ranges<Result>(),
      Fields{ListField<Result, List<Din743Stress, 3>>{&Result::stresses, "stresses",
                                                      "acting loads: tension, bending, torsion"}});
}

constexpr auto choices_of(Notch) {
  using N = Notch;
  return std::array{
      ChoiceName<N>{N::untold, "not_given", "not given: no section is assessed with it", "unstated"},
      ChoiceName<N>{N::smooth, "smooth", "no notch"},
      ChoiceName<N>{N::shoulder, "shoulder", "shoulder from d to D with the radius r"},
      ChoiceName<N>{N::round_groove, "round-groove", "round groove with radius r, outer diameter D"},
      ChoiceName<N>{N::rectangular_groove, "rectangular-groove",
                    "rectangular groove of width w with corner radius r, outer diameter D: retaining ring"},
      ChoiceName<N>{N::v_groove, "v-groove", "sharp V-groove, r about 0.1 mm, outer diameter D"},
      ChoiceName<N>{N::keyway, "keyway", "one keyway with its hub"},
      ChoiceName<N>{N::two_keyways, "two-keyways", "two keyways with their hub"},
      ChoiceName<N>{N::press_fit, "press-fit", "press-fitted hub, at its edge"},
      ChoiceName<N>{N::cross_hole, "cross-hole", "cross hole of radius r"},
      ChoiceName<N>{N::alpha, "alpha", "stress concentration factors as given"},
      ChoiceName<N>{N::beta, "beta", "fatigue notch factors as given: splines, undercuts, tests"}};
}

constexpr auto choices_of(SteelGroup) {
  using G = SteelGroup;
  return std::array{
      ChoiceName<G>{G::none, "none", "not given: R_m and R_e are those of this size"},
      ChoiceName<G>{G::quenched_tempered, "quenched-tempered", "quenched and tempered, d_B 16 mm"},
      ChoiceName<G>{G::case_hardening_crnimo, "case-hardening-CrNiMo", "CrNiMo steel for case hardening, core, 16 mm"},
      ChoiceName<G>{G::case_hardening, "case-hardening", "other steel for case hardening, core, d_B 16 mm"},
      ChoiceName<G>{G::nitriding, "nitriding", "nitriding steel, d_B 100 mm"},
      ChoiceName<G>{G::structural, "structural", "structural steel, d_B 100 mm, yield strength up to 32 mm"}};
}

constexpr auto choices_of(Layer) {
  return std::array{ChoiceName<Layer>{Layer::none, "none", "as the core"},
                    ChoiceName<Layer>{Layer::hard, "hard", "hard: case hardened, nitrided, induction hardened"}};
}

}  // namespace loadpath::fatigue
