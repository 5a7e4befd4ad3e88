// A column in parts of different section, with loads at the top and at the steps, and its self-weight.
//
// Decides by how much all loads together may grow until the column buckles elastically, exactly (critical.hpp), the
// effective length of every part under its own force, and with it the critical stress of the part: by Johnson and
// Euler with the yield strength, by Euler up to a proportional limit. A single part is the uniform column under its
// self-weight. Straight, central loads that keep their direction, vertical where the weight counts; buckling about one
// axis, that of the second moments given. Forces are positive in compression. Not covered: eccentric and transverse
// loads, buckling about the other axis, torsional and local buckling, elastic ends, codes.
#pragma once

#include "calculators/column/stepped/types.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::column {

struct Stepped : SteppedTypes {
  static constexpr auto id = "column.stepped";
  static constexpr auto title = "Stepped column and column under its own weight";
  static constexpr auto scope =
      "Elastic critical load factor of a column of one or more parts of different section under forces at the top and "
      "at the steps, distributed axial loads and its self-weight, exact; effective length and critical stress of each "
      "part; eccentric and transverse loads, torsional and local buckling, the other axis and codes are not covered.";
  static constexpr auto source = "[Timoshenko-Gere], [Wittrick], [Anderson-Woodward], [Johnson], [B25]";
  static constexpr auto headline = "alpha_cr = {alpha_cr}";
  static constexpr auto subject = "buckling";
  static constexpr auto synonyms =
      "stepped column, crane column, mill column, variable section, self-weight buckling, own weight, heavy column, "
      "greatest height, mast, intermediate load, load factor, abgesetzte Stütze, Eigengewicht, Knicken, "
      "ступенчатая колонна, собственный вес, устойчивость";
  static constexpr auto example = R"([project]
title = "Column with a crane bracket"

[column]
calculator = "column.stepped"
foot = "fixed"
top = "free"
parts = [
  { name = "lower", l = "3 m", d = "160 mm", P = "100 kN" },
  { name = "upper", l = "2 m", d = "125 mm", P = "60 kN" },
]
E = "210 GPa"
rho = "7850 kg/m^3"
R_e = "235 MPa"
n_st = 2.5
)";

  static constexpr Fields inputs{
      ListField{&Input::parts, "parts", "parts of the column, from its foot to its top"},
      Choice{&Input::foot, "foot", "support of the foot: fixed or pinned"},
      Choice{&Input::top, "top", "support of the top: free, pinned, fixed or guided"},
      Choice{&Input::orientation, "orientation", "orientation, for the self-weight: vertical or horizontal"}
          .may_be_missing(),
      Field{&Input::E, "E", GPa, "modulus of elasticity"}.positive().usually(least_E, most_E).from("material", "E"),
      Field{&Input::rho, "rho", kg_per_m3, "density, for the self-weight; omitted: without weight"}
          .positive()
          .usually(100, 23000)
          .from("material", "rho")
          .where_it_has(),
      Field{&Input::R_e, "R_e", MPa, "yield strength"}
          .positive()
          .usually(10, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "t")
          .where_it_has(),
      Field{&Input::sigma_P, "sigma_P", MPa, "proportional limit: Euler's formula up to it, in place of Johnson's"}
          .positive()
          .usually(5, 2000)
          .may_be_missing(),
      Field{&Input::n_st, "n_st", ratio, "required safety factor against buckling"}
          .at_least(1)
          .usually(1.5, 10)
          .customarily_at_least(1.5)
          .may_be_missing()
          .factor()};

  static constexpr Fields results{
      Field{&Result::t, "t", mm,
            "thickness that selects the material strength: largest diameter; unknown: lowest value of the table"},
      Field{&Result::F, "F", kN, "compressive force at the foot"},
      Field{&Result::alpha_cr, "alpha_cr", ratio, "elastic critical load factor of all loads together"},
      Field{&Result::F_cr, "F_cr", kN, "force at the foot when the column buckles elastically"},
      Field{&Result::u, "u", ratio, "buckling: n_st x stress / critical stress, maximum of all parts"}.check("n_st"),
      Field{&Result::r_P, "r_P", ratio, "critical stress / proportional limit, maximum of all parts"}.limit(0, 1,
                                                                                                            "sigma_P"),
      ListField{&Result::members, "members", "parts with their forces and effective lengths"}};

  static bool sections_given(const Input& in);
  static FieldFault section_missing(const Input& in);
  static bool is_kinematically_stable(const Input& in);
  static bool sections_fit(const Input& in);
  static Applies loaded(const Input& in);
  static Applies of_walls(const Input& in);
  static Applies about_other_axis(const Input& in);
  static Applies weighs(const Input& in);

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.parts.empty(); }, "parts", "a column needs at least one part"},
      Rule<Input>{&sections_given, "parts", "each part needs its section: d of a round bar, or A and I",
                  &section_missing},
      Rule<Input>{&sections_fit, "parts",
                  "A and I of a part must be of one section: I is at most that of a tube as "
                  "wide as the part is long"},
      Rule<Input>{&is_kinematically_stable, "foot, top",
                  "a column with a pinned foot and a free top falls: fix its foot or hold "
                  "its top"},
      Rule<Input>{[](const Input& in) { return is_set(in.E); }, "E", "give a material, or the modulus E"},
      Rule<Input>{[](const Input& in) { return !is_set(in.n_st) || is_set(in.R_e) || is_set(in.sigma_P); },
                  "n_st, R_e, sigma_P",
                  "a safety factor needs the yield strength R_e (or a material), or the proportional limit sigma_P"},
      Rule<Input>{[](const Input& in) { return !is_set(in.sigma_P) || !is_set(in.R_e) || in.sigma_P <= in.R_e; },
                  "sigma_P, R_e", "the proportional limit must not exceed the yield strength"}};
  static constexpr std::array modes{
      Mode<Input>{"buckling", "flexural buckling and yielding of the parts", &loaded}.judged_by("u, r_P"),
      Mode<Input>{"local", "local buckling of walls", &of_walls},
      Mode<Input>{"torsional", "torsional and torsional-flexural buckling", &of_walls},
      Mode<Input>{"other_axis", "buckling about the other axis", &about_other_axis}.special(),
      Mode<Input>{"weight", "self-weight", &weighs}.special(),
      Mode<Input>{"lateral", "bending due to eccentric and transverse loads", &unseen<Input>}
          .in_service()
          .by_companions(),
      Mode<Input>{"joint", "strength of the steps and supports", &unseen<Input>},
      Mode<Input>{"fatigue", "fatigue", &unseen<Input>}.in_service().assessed_additionally_in(
          "fatigue.life, fatigue.history")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::column
