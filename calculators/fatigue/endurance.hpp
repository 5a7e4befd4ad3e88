// The fatigue limit of a material in symmetric cycles, measured or estimated from the tensile strength, and what shape,
// size and surface leave of it in a part.
//
// Decides sigma_-1 of the smooth polished specimen by one published rule, the notch factor K_f, and the fatigue limit
// of the part by one school: Serensen's K_D (GOST 25.504, the school of [B20]) or Marin's factors (Shigley). Torsion
// alike, with tau for sigma. Limits hold for r = -1.
// Not covered: mean stress, life, histories, safety, temperature, corrosion, press fits.
#pragma once

#include "calculators/fatigue/size_and_surface.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/heat_treatment.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <tuple>

namespace loadpath::fatigue {

struct Endurance {
  static constexpr auto id = "fatigue.endurance";
  static constexpr auto title = "Fatigue limit of a material and of a part";
  static constexpr auto scope =
      "Fatigue limit in symmetric cycles of a smooth specimen, measured or estimated, and of a part with its shape, "
      "size "
      "and surface. Mean stress, life, temperature and corrosion are not covered.";
  static constexpr auto source = "[B20], [DIN743], [FKM], [GOST25504], [Shigley6]";
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

  enum class Group {
    carbon_steel,
    alloy_steel,
    case_hardening_steel,
    stainless_steel,
    cast_steel,
    grey_iron,
    ductile_iron,
    malleable_iron,
    wrought_aluminium,
    cast_aluminium,
    other_non_ferrous
  };
  enum class RuleOf { textbook, din743, fkm, shigley };
  enum class Loading { bending, tension, torsion };
  enum class School { serensen, marin };
  enum class Finish { ground, machined, hot_rolled, forged };

  struct Input {
    Stress R_m = unset<Stress>;
    Group group = Group::carbon_steel;
    Loading loading = Loading::bending;
    RuleOf rule = RuleOf::textbook;
    Stress sigma_W = unset<Stress>;
    School school = School::serensen;
    Length d = unset<Length>, d_h = unset<Length>;
    double epsilon = unset<double>, K_t = 1.0, q = unset<double>;
    Length r_n = unset<Length>;
    double K_f = unset<double>;
    Length R_z = unset<Length>;
    double beta_F = unset<double>, beta_V = 1.0;
    Finish finish = Finish::ground;
  };
  static bool rule_fits(const Input& in);
  static FieldFault misfit(const Input& in);
  static constexpr std::tuple inputs{
      Field{&Input::R_m, "R_m", MPa, "tensile strength"}.positive().usually(80, 2500).from("material", "R_m", "d_h, d"),
      Choice{&Input::group, "group", "group of materials"},
      Choice{&Input::loading, "loading", "kind of stress that varies"},
      Choice{&Input::rule, "rule", "rule that estimates the fatigue limit"}.may_be_missing(),
      Field{&Input::sigma_W, "sigma_W", MPa, "measured fatigue limit of smooth specimens, r = -1, in place of a rule"}
          .positive()
          .usually(10, 1500)
          .may_be_missing(),
      Choice{&Input::school, "school", "school that goes from the specimen to the part"}.may_be_missing(),
      Field{&Input::d, "d", mm, "diameter of the part at the section"}.positive().usually(1, 1000).may_be_missing(),
      diameter_at_heat_treatment(&Input::d_h),
      Field{&Input::epsilon, "epsilon", ratio, "size factor, in place of one from d"}.within(0.3, 1).may_be_missing(),
      Field{&Input::K_t, "K_t", ratio, "stress concentration factor of the shape, on the net section"}.within(1, 10),
      Field{&Input::q, "q", ratio, "notch sensitivity"}.within(0, 1).may_be_missing(),
      Field{&Input::r_n, "r_n", mm, "radius of the notch, for the notch sensitivity of steels by Neuber"}
          .positive()
          .usually(0.1, 100)
          .may_be_missing(),
      Field{&Input::K_f, "K_f", ratio, "fatigue notch factor, in place of K_t"}.within(1, 10).may_be_missing(),
      Field{&Input::R_z, "R_z", um, "roughness, for the surface of Serensen's school"}
          .positive()
          .usually(0.1, 400)
          .may_be_missing(),
      Field{&Input::beta_F, "beta_F", ratio, "surface factor, in place of one from R_z"}
          .within(0.2, 1)
          .may_be_missing(),
      Field{&Input::beta_V, "beta_V", ratio, "factor of a hardened surface"}.within(1, 4).factor(),
      Choice{&Input::finish, "finish", "surface, for Marin's school"}.may_be_missing()};

  struct Result {
    Stress sigma_m1 = unset<Stress>, sigma_low = unset<Stress>, sigma_high = unset<Stress>;
    double N_0 = unset<double>;
    double K_f = unset<double>, epsilon = unset<double>, beta_F = unset<double>, K_D = unset<double>;
    double k_a = unset<double>, k_b = unset<double>;
    Stress sigma_D = unset<Stress>;
    double x_d = unset<double>, x_n = unset<double>;
  };
  static constexpr std::tuple results{
      Field{&Result::sigma_m1, "sigma_m1", MPa, "fatigue limit of the smooth specimen; shear in torsion"},
      Field{&Result::sigma_low, "sigma_low", MPa, "lower end of the rule's band"},
      Field{&Result::sigma_high, "sigma_high", MPa, "upper end of the rule's band"},
      Field{&Result::N_0, "N_0", ratio, "cycles that the limit stands for: of non-ferrous metals conventional"},
      Field{&Result::K_f, "K_f", ratio, "fatigue notch factor"},
      Field{&Result::epsilon, "epsilon", ratio, "size factor of Serensen's school"},
      Field{&Result::beta_F, "beta_F", ratio, "surface factor of Serensen's school"},
      Field{&Result::K_D, "K_D", ratio, "factor of shape, size and surface together: specimen over part"},
      Field{&Result::k_a, "k_a", ratio, "surface factor of Marin's school"},
      Field{&Result::k_b, "k_b", ratio, "size factor of Marin's school"},
      Field{&Result::sigma_D, "sigma_D", MPa, "fatigue limit of the part, r = -1, as nominal stress"},
      Field{&Result::x_d, "x_d", ratio, "d within the range of the size factor: 0 least, 1 largest diameter"}.limit(
          0, 1 + 1e-9, "d"),
      Field{&Result::x_n, "x_n", ratio, "R_m within the range of Neuber's constant: 0 least, 1 largest strength"}.limit(
          0, 1, "r_n")};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.R_m) || is_set(in.sigma_W); }, "R_m, sigma_W",
                  "give the tensile strength R_m (or a material) for an estimate, or the measured limit sigma_W"},
      Rule<Input>{&rule_fits, "rule, group, loading", "the rule does not cover this group and loading", &misfit},
      Rule<Input>{
          [](const Input& in) { return !(is_set(in.K_f) && (in.K_t != 1.0 || is_set(in.q) || is_set(in.r_n))); },
          "K_f, K_t, q, r_n", "give the notch as K_f, or as K_t with q or r_n, never both"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.q) && is_set(in.r_n)); }, "q, r_n",
                  "give the notch sensitivity as q, or the radius r_n that it follows from, never both"},
      Rule<Input>{[](const Input& in) { return in.K_t == 1.0 || is_set(in.q) || is_set(in.r_n); }, "K_t, q, r_n",
                  "a notch needs its sensitivity: q, or the radius r_n for steels; q = 1 is on the safe side"},
      Rule<Input>{[](const Input& in) { return !is_set(in.r_n) || (is_set(in.R_m) && in.group <= Group::cast_steel); },
                  "r_n, group, R_m", "Neuber's constant is that of steels and needs R_m: give q for other materials"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.epsilon) && is_set(in.d)); }, "epsilon, d",
                  "give the size factor epsilon or the diameter d that it follows from, never both"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.beta_F) && is_set(in.R_z)); }, "beta_F, R_z",
                  "give the surface factor beta_F or the roughness R_z that it follows from, never both"},
      Rule<Input>{[](const Input& in) { return is_set(in.R_m) || !(is_set(in.R_z) || in.school == School::marin); },
                  "R_m, R_z, school", "the surface factor depends on the tensile strength R_m: give it"},
      Rule<Input>{[](const Input& in) {
                    return in.school == School::serensen ||
                           !(is_set(in.epsilon) || is_set(in.R_z) || is_set(in.beta_F) || in.beta_V != 1.0);
                  },
                  "school, epsilon, R_z, beta_F, beta_V",
                  "epsilon, R_z, beta_F and beta_V belong to Serensen's school; Marin's takes finish and d"},
      Rule<Input>{[](const Input& in) { return !(in.sigma_W >= in.R_m); }, "sigma_W, R_m",
                  "a fatigue limit is below the tensile strength: what breaks at once lasts no cycles"},
      heat_treated_before_turning<Input>()};

  static constexpr std::array modes{
      Mode<Input>{"size", "a diameter for which no size factor was measured",
                  [](const Input& in) { return where(is_set(in.d)); }}
          .judged_by("x_d")
          .of_shape(),
      Mode<Input>{"notch", "a strength for which no notch sensitivity was measured",
                  [](const Input& in) { return where(is_set(in.r_n)); }}
          .judged_by("x_n")
          .of_shape(),
      Mode<Input>{"surroundings", "corrosion, heat, fretting under press fits", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Endurance::Group) {
  using G = Endurance::Group;
  return std::array{ChoiceName<G>{G::carbon_steel, "carbon-steel", "carbon and structural steel"},
                    ChoiceName<G>{G::alloy_steel, "alloy-steel", "low alloy steel, also quenched and tempered"},
                    ChoiceName<G>{G::case_hardening_steel, "case-hardening-steel", "steel for case hardening, core"},
                    ChoiceName<G>{G::stainless_steel, "stainless-steel", "stainless steel"},
                    ChoiceName<G>{G::cast_steel, "cast-steel", "cast steel"},
                    ChoiceName<G>{G::grey_iron, "grey-iron", "grey cast iron"},
                    ChoiceName<G>{G::ductile_iron, "ductile-iron", "cast iron with spheroidal graphite"},
                    ChoiceName<G>{G::malleable_iron, "malleable-iron", "malleable cast iron"},
                    ChoiceName<G>{G::wrought_aluminium, "wrought-aluminium", "wrought aluminium alloy"},
                    ChoiceName<G>{G::cast_aluminium, "cast-aluminium", "cast aluminium alloy"},
                    ChoiceName<G>{G::other_non_ferrous, "non-ferrous", "other non-ferrous metals"}};
}

constexpr auto choices_of(Endurance::RuleOf) {
  using R = Endurance::RuleOf;
  return std::array{ChoiceName<R>{R::textbook, "textbook", "band of the textbook in bending, its lower end"},
                    ChoiceName<R>{R::din743, "din743", "DIN 743-3: 0.5, 0.4, 0.3 of R_m; steels"},
                    ChoiceName<R>{R::fkm, "fkm", "FKM 2012 by group; tension and torsion"},
                    ChoiceName<R>{R::shigley, "shigley", "half of R_m, 700 MPa at most, with load factor; steels"}};
}

constexpr auto choices_of(Endurance::Loading) {
  using L = Endurance::Loading;
  return std::array{ChoiceName<L>{L::bending, "bending", "bending, rotating"},
                    ChoiceName<L>{L::tension, "tension", "tension and compression"},
                    ChoiceName<L>{L::torsion, "torsion", "torsion; all stresses are shear stresses"}};
}

constexpr auto choices_of(Endurance::School) {
  using S = Endurance::School;
  return std::array{
      ChoiceName<S>{S::serensen, "serensen", "K_D of Serensen and GOST 25.504, size and roughness of DIN 743"},
      ChoiceName<S>{S::marin, "marin", "Marin's factors after Shigley, 9th edition"}};
}

constexpr auto choices_of(Endurance::Finish) {
  using F = Endurance::Finish;
  return std::array{
      ChoiceName<F>{F::ground, "ground", "ground"}, ChoiceName<F>{F::machined, "machined", "machined or cold drawn"},
      ChoiceName<F>{F::hot_rolled, "hot-rolled", "hot rolled"}, ChoiceName<F>{F::forged, "forged", "as forged"}};
}

}  // namespace loadpath::fatigue
