// The fatigue limit of a material in symmetric cycles, measured or estimated from the tensile strength, and what shape,
// size and surface leave of it in a part.
//
// Decides sigma_-1 of the smooth polished specimen by one published rule, the notch factor K_f, and the fatigue limit
// of the part by one school: Serensen's K_D (GOST 25.504, the school of [B20]) or Marin's factors (Shigley): surface
// by either edition, size of rotating or stationary parts, load, temperature, reliability. Torsion alike, with tau
// for sigma. Limits are for r = -1 and a survival of 50 %, unless P_s says more. Without size or roughness it stays
// the specimen's limit, and is not assessed as the part's; for a part as small and smooth give epsilon = 1, beta_F =
// 1. Not covered: mean stress, life (fatigue.life), histories, safety, corrosion, press fits. Not checked against the
// source: Peterson's notch sensitivity, that of cast iron, the surface factors of the 11th edition except for ground
// surfaces.
#pragma once

#include "calculators/fatigue/endurance_types.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/fit_units.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::fatigue {

struct Endurance : EnduranceTypes {
  static constexpr auto id = "fatigue.endurance";
  static constexpr auto title = "Fatigue limit of material and part";
  static constexpr auto scope =
      "Fully reversed fatigue limit of a smooth specimen, measured or estimated, and of a part with its stress "
      "concentration, size and surface by Serensen or Marin, the latter with temperature and reliability "
      "factors; mean stress and life: fatigue.life; corrosion is not covered.";
  static constexpr auto source = "[B20], [DIN743], [FKM], [GOST25504], [Shigley6]";
  static constexpr auto headline = "sigma_D = {sigma_D}";
  static constexpr auto synonyms =
      "fatigue limit, endurance limit, Marin factors, surface factor, size factor, notch sensitivity, "
      "fatigue notch factor, stress concentration, reliability factor, Dauerfestigkeit, Wechselfestigkeit, "
      "Kerbwirkungszahl, Größenfaktor, Oberflächenfaktor, предел выносливости, коэффициент концентрации, "
      "масштабный фактор, Серенсен";
  static constexpr auto example = R"([project]
title = "Shoulder of a shaft"

[shoulder]
calculator = "fatigue.endurance"
R_m = "690 MPa"
group = "carbon-steel"
rule = "din743"
loading = "bending"
school = "serensen"
d = "32 mm"
K_t = 1.65
r_n = "3 mm"
R_z = "6.3 um"
)";

  static bool rule_fits(const Input& in);
  static FieldFault misfit(const Input& in);
  static constexpr Fields inputs{
      Field{&Input::R_m, "R_m", MPa, "tensile strength"}
          .positive()
          .usually(80, 2500)
          .customarily_at_most(most_tensile_strength)
          .from("material", "R_m", "d_h, d"),
      modulus_of_material(&Input::E),
      density_of_material(&Input::rho),
      Choice{&Input::group, "group", "group of materials"},
      Choice{&Input::loading, "loading", "loading type"},
      Choice{&Input::rule, "rule", "rule for estimating the fatigue limit"}.may_be_missing(),
      Field{&Input::sigma_W, "sigma_W", MPa, "measured fatigue limit of smooth specimens, r = −1, in place of a rule"}
          .positive()
          .usually(10, 1500)
          .may_be_missing(),
      Choice{&Input::school, "school", "method of correction factors"}.may_be_missing(),
      Field{&Input::d, "d", mm, "diameter of the part at the section"}.positive().usually(1, 1000).may_be_missing(),
      diameter_at_heat_treatment(&Input::d_h),
      Field{&Input::epsilon, "epsilon", ratio, "size factor, in place of one from d"}
          .within(0.3, 1)
          .usually(0.5, 1)
          .may_be_missing(),
      Field{&Input::K_t, "K_t", ratio, "stress concentration factor of the shape, on the net section"}
          .within(1, 10)
          .made_for_same("r_n")
          .usually(1, 6),
      Field{&Input::q, "q", ratio, "notch sensitivity"}.within(0, 1).usually(0.2, 1).may_be_missing(),
      Field{&Input::r_n, "r_n", mm, "radius of the notch, for the notch sensitivity of steels"}
          .positive()
          .usually(0.1, 100)
          .may_be_missing(),
      Field{&Input::K_f, "K_f", ratio, "fatigue notch factor, in place of K_t"}
          .within(1, 10)
          .usually(1, 6)
          .may_be_missing(),
      Field{&Input::R_z, "R_z", um, "roughness, for the surface of Serensen's school"}
          .positive()
          .usually(0.1, 400)
          .customarily_at_least(0.1)
          .may_be_missing(),
      Field{&Input::beta_F, "beta_F", ratio, "surface factor, in place of one from R_z"}
          .within(0.2, 1)
          .usually(0.4, 1)
          .may_be_missing(),
      Field{&Input::beta_V, "beta_V", ratio, "factor of a hardened surface"}
          .within(1, 4)
          .usually(1, 2.8)
          .customarily_at_most(2.8)
          .factor(),
      Choice{&Input::finish, "finish", "surface, for Marin's school"}.may_be_missing(),
      Choice{&Input::sensitivity, "sensitivity", "method for the notch sensitivity"}.may_be_missing(),
      Choice{&Input::edition, "edition", "edition of the surface factors of Marin's school"}.may_be_missing(),
      Choice{&Input::turning, "turning", "rotating or non-rotating part, for the size factor of Marin"}
          .may_be_missing(),
      Field{&Input::h, "h", mm, "height of a non-rotating rectangular section, replaces d"}.positive().may_be_missing(),
      Field{&Input::b, "b", mm, "width of the rectangular section"}.positive().may_be_missing(),
      Field{&Input::k_a, "k_a", ratio, "surface factor of Marin's school, in place of one from finish"}
          .within(0.1, 1)
          .usually(0.2, 1)
          .may_be_missing(),
      Field{&Input::k_b, "k_b", ratio, "size factor of Marin's school, in place of one from d"}
          .within(0.3, 1)
          .usually(0.6, 1)
          .may_be_missing(),
      Field{&Input::k_c, "k_c", ratio, "load factor, where sigma_W was measured in rotating bending"}
          .within(0.3, 1)
          .usually(0.55, 1)
          .may_be_missing(),
      Field{&Input::T, "T", scale_of_heat, "temperature of the part, where R_m is that of room temperature"}
          .positive()
          .may_be_missing(),
      Field{&Input::P_s, "P_s", ratio, "reliability: share of parts that survive the limit; omitted: 0.5"}
          .within(0.5, 0.999999)
          .customarily_at_least(0.9)
          .may_be_missing()};

  static constexpr Fields results{
      Field{&Result::sigma_m1, "sigma_m1", MPa, "fatigue limit of the smooth specimen; shear in torsion"},
      Field{&Result::sigma_low, "sigma_low", MPa, "lower bound of the rule"},
      Field{&Result::sigma_high, "sigma_high", MPa, "upper bound of the rule"},
      Field{&Result::N_0, "N_0", ratio, "number of cycles of the limit (conventional for non-ferrous metals)"},
      Field{&Result::K_f, "K_f", ratio, "fatigue notch factor"},
      Field{&Result::epsilon, "epsilon", ratio, "size factor of Serensen's school"},
      Field{&Result::beta_F, "beta_F", ratio, "surface factor of Serensen's school"},
      Field{&Result::K_D, "K_D", ratio, "factor of shape, size and surface together: specimen over part"},
      Field{&Result::k_a, "k_a", ratio, "surface factor of Marin's school"},
      Field{&Result::k_b, "k_b", ratio, "size factor of Marin's school"},
      Field{&Result::k_c, "k_c", ratio, "load factor of Marin's school"},
      Field{&Result::k_d, "k_d", ratio, "temperature factor of Marin's school"},
      Field{&Result::k_e, "k_e", ratio, "reliability factor of Marin's school"},
      Field{&Result::d_e, "d_e", mm, "diameter of the equivalent rotating bar"},
      Field{&Result::sigma_D, "sigma_D", MPa, "fatigue limit of the part, r = −1, as nominal stress"},
      Field{&Result::x_d, "x_d", ratio,
            "position of d in the range of the size factor: 0 at its minimum, 1 at its maximum"}
          .limit(0, 1 + 1e-9, "d, h"),
      Field{&Result::x_n, "x_n", ratio,
            "position of R_m in the range of the notch sensitivity: 0 at its minimum, 1 at its maximum"}
          .limit(0, 1, "r_n"),
      Field{&Result::x_r, "x_r", ratio, "0.1 mm over r_n: a sharper notch counts as a crack (limit set by loadpath)"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Result::x_Rz, "x_Rz", ratio, "roughness / 200 um (limit set by loadpath)"}.limit(0, 1, "R_z"),
      Field{&Result::x_T, "x_T", ratio,
            "position of T in the range of the temperature factor: 0 at its minimum, 1 at its maximum"}
          .limit(-1e-9, 1 + 1e-9, "T"),
      modulus_over_steel<Result>(&Result::x_E)};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.R_m) || is_set(in.sigma_W); }, "R_m, sigma_W",
                  "give the tensile strength R_m (or a material) for an estimate, or the measured limit sigma_W"},
      group_of_metal<Input>(),
      Rule<Input>{&rule_fits, "rule, group, loading", "the rule does not cover this group and loading", &misfit},
      Rule<Input>{
          [](const Input& in) { return !(is_set(in.K_f) && (in.K_t != 1.0 || is_set(in.q) || is_set(in.r_n))); },
          "K_f, K_t, q, r_n", "give the notch as K_f, or as K_t with q or r_n, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.r_n) || is_set(in.K_f) || in.K_t > 1.0; }, "K_t, r_n",
                  "a notch radius r_n needs K_t; otherwise omit r_n"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.q) && is_set(in.r_n)); }, "q, r_n",
                  "give either the notch sensitivity q or the radius r_n"},
      Rule<Input>{[](const Input& in) {
                    return in.K_t == 1.0 || is_set(in.q) || is_set(in.r_n) || in.sensitivity == Sensitivity::cast_iron;
                  },
                  "K_t, q, r_n",
                  "a notch needs its sensitivity: q, or the radius r_n for steels; q = 1 is on the safe side"},
      Rule<Input>{[](const Input& in) { return !is_set(in.r_n) || (is_set(in.R_m) && in.group <= Group::cast_steel); },
                  "r_n, group, R_m",
                  "the constants of Neuber and Peterson are those of steels and need R_m: give q for other materials"},
      Rule<Input>{[](const Input& in) {
                    const bool iron = in.group >= Group::grey_iron && in.group <= Group::malleable_iron;
                    return in.sensitivity != Sensitivity::cast_iron || (iron && !is_set(in.q));
                  },
                  "sensitivity, group, q", "sensitivity = \"cast-iron\" is q = 0.2 of cast iron, in place of q"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.epsilon) && is_set(in.d)); }, "epsilon, d",
                  "give either the size factor epsilon or the diameter d"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.beta_F) && is_set(in.R_z)); }, "beta_F, R_z",
                  "give either the surface factor beta_F or the roughness R_z"},
      Rule<Input>{[](const Input& in) {
                    const bool marin = in.school == School::marin && !is_set(in.k_a);
                    return is_set(in.R_m) || !(is_set(in.R_z) || marin);
                  },
                  "R_m, R_z, school", "the surface factor needs the tensile strength R_m"},
      Rule<Input>{[](const Input& in) {
                    return in.school == School::serensen ||
                           !(is_set(in.epsilon) || is_set(in.R_z) || is_set(in.beta_F) || in.beta_V != 1.0);
                  },
                  "school, epsilon, R_z, beta_F, beta_V",
                  "epsilon, R_z, beta_F and beta_V belong to Serensen's method; Marin's uses finish and d"},
      Rule<Input>{[](const Input& in) {
                    return in.school == School::marin ||
                           !(is_set(in.T) || is_set(in.P_s) || is_set(in.k_a) || is_set(in.k_b) || is_set(in.k_c) ||
                             is_set(in.h) || is_set(in.b) || in.turning == Turning::standing ||
                             in.edition != Edition::ninth);
                  },
                  "school, T, P_s, k_a, k_b, k_c, h, b, turning, edition",
                  "T, P_s, k_a, k_b, k_c, h, b, turning and edition belong to Marin's method"},
      Rule<Input>{[](const Input& in) { return !is_set(in.k_b) || !(is_set(in.d) || is_set(in.h)); }, "k_b, d, h",
                  "give either the size factor k_b or the size"},
      Rule<Input>{[](const Input& in) { return is_set(in.h) == is_set(in.b) && !(is_set(in.h) && is_set(in.d)); },
                  "h, b, d", "give the diameter d, or height h and width b of a rectangle"},
      Rule<Input>{[](const Input& in) {
                    return !is_set(in.h) || (in.turning == Turning::standing && in.loading != Loading::torsion);
                  },
                  "h, b, turning, loading",
                  "the size factor of a rectangle applies to bending and tension of a non-rotating part: "
                  "turning = \"standing\""},
      Rule<Input>{[](const Input& in) { return !is_set(in.T) || in.group <= Group::cast_steel; }, "T, group",
                  "the temperature factor applies to steels: give R_m at the temperature of the part instead of T"},
      Rule<Input>{[](const Input& in) { return !is_set(in.k_c) || is_set(in.sigma_W); }, "k_c, sigma_W",
                  "k_c requires a measured limit sigma_W; the rules include their load factors"},
      lasts_below_tensile<&Input::sigma_W, Input>("sigma_W, R_m"),
      heat_treated_before_turning<Input>()};

  /// Tension knows no size effect; a size factor that is typed is the user's word.
  static Applies has_size(const Input& in) {
    return where(is_set(in.d) || is_set(in.h) ||
                 (in.loading != Loading::tension && !is_set(in.epsilon) && !is_set(in.k_b)));
  }
  static Applies has_surface(const Input& in) { return where(in.school == School::serensen && !is_set(in.beta_F)); }
  static bool is_steel(Group group) { return group <= Group::cast_steel; }
  static constexpr auto normal = "bending, tension", shear = "torsion";
  static constexpr auto endless_normal =
      "bending/wrought-aluminium, bending/cast-aluminium, bending/non-ferrous, tension/wrought-aluminium, "
      "tension/cast-aluminium, tension/non-ferrous";
  static constexpr auto endless_shear = "torsion/wrought-aluminium, torsion/cast-aluminium, torsion/non-ferrous";
  static constexpr std::array meanings{Meaning{"sigma_D", strength_in_normal, "loading, group", endless_normal},
                                       Meaning{"sigma_D", strength_in_shear, "loading, group", endless_shear},
                                       Meaning{"sigma_D", limit_in_normal, "loading", normal},
                                       Meaning{"sigma_D", limit_in_shear, "loading", shear},
                                       Meaning{"sigma_W, sigma_m1", specimen_in_bending, "loading", "bending"},
                                       Meaning{"sigma_W, sigma_m1", specimen_in_tension, "loading", "tension"},
                                       Meaning{"sigma_W, sigma_m1", specimen_in_torsion, "loading", "torsion"},
                                       Meaning{"K_t", notch_in_tension, "loading", "tension"},
                                       Meaning{"K_t", notch_in_bending, "loading", "bending"},
                                       Meaning{"K_t", notch_in_torsion, "loading", "torsion"},
                                       Meaning{"K_D", factor_in_normal, "loading", normal},
                                       Meaning{"K_D", factor_in_shear, "loading", shear}};

  static constexpr std::array notch_claims{NotchClaim{"sigma_D", "K_f", "K_t"}};

  static constexpr std::array modes{
      Mode<Input>{"size", "validity: size factor", &has_size}.judged_by("x_d").wanting("d, epsilon").of_shape(),
      Mode<Input>{"surface", "validity: surface factor", &has_surface}
          .judged_by("x_Rz")
          .wanting("R_z, beta_F")
          .of_shape(),
      Mode<Input>{"notch", "validity: notch sensitivity data", [](const Input& in) { return where(is_set(in.r_n)); }}
          .judged_by("x_n, x_r")
          .of_shape(),
      Mode<Input>{"metal", "validity: modulus of steel",
                  [](const Input& in) { return where(is_set(in.E) && is_steel(in.group)); }}
          .judged_by("x_E")
          .of_shape(),
      Mode<Input>{"temperature", "validity: temperature factor", [](const Input& in) { return where(is_set(in.T)); }}
          .judged_by("x_T")
          .of_shape(),
      Mode<Input>{"reliability", "validity: reliability of the fatigue limit",
                  [](const Input& in) { return where(in.school == School::marin && !is_set(in.P_s)); }}
          .wanting("P_s")
          .of_shape(),
      Mode<Input>{"surroundings", "corrosion, heat and fretting", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::fatigue
