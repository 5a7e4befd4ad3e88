// The lightest section of a family, or of several, that carries a compressed bar.
//
// Every row of the section tables of these families is assessed as in column.buckling, by the chosen method; those
// that pass are ranked by mass, lighter ones list the reason of failure, and the best one is calculated in full. The
// strength of a material falls with the thickness: all are judged with that of the thickest one up to the section
// found, which is on the safe side for the others. Not covered: what column.buckling does not cover. Sections thicker
// than the material is given for are not assessed.
#pragma once

#include "calculators/column/bounds.hpp"
#include "calculators/column/buckling.hpp"
#include "calculators/column/lightest/types.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/quantity/drive_units.hpp"

#include <vector>

namespace loadpath::column {

struct Lightest : LightestTypes {
  static constexpr auto id = "column.lightest";
  static constexpr auto title = "Lightest column section";
  static constexpr auto scope =
      "Ranking of tabulated sections of the given families by mass per length for an axial force, with the "
      "reason for the rejection of each lighter section and the complete column.buckling calculation of the "
      "best one; class 4 sections and holes in tension members are "
      "not covered.";
  static constexpr auto source = Buckling::source;
  static constexpr auto headline = "{section}";
  static constexpr auto subject = "buckling";
  static constexpr auto synonyms =
      "column selection, section selection, lightest section, optimum column, IPE, HEA, RHS, CHS, strut selection, "
      "Profilauswahl, Stützenbemessung, подбор сечения, колонна, стойка";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Column of a platform"

[post]
calculator = "column.lightest"
families = ["HEA", "HEB"]
P = "900 kN"
l = "4.5 m"
ends = "pinned_pinned"
material = "S235"
method = "ec3"
gamma_M1 = 1
gamma_F = 1
)";

  static constexpr auto inputs = join(
      Fields{ListField{&Input::families, "families", "section families to select from: IPE, or W14"}.as_arrays()},
      held_inputs<Input>(),
      Fields{
          Choice{&Input::kind, "kind", "section type where the table does not give it (round tubes)"}.may_be_missing(),
          Field{&Input::h_max, "h_max", mm, "maximum section height"}.positive().may_be_missing(),
          Field{&Input::b_max, "b_max", mm, "maximum section width"}.positive().may_be_missing()},
      material_inputs<Input>(),
      Fields{ListField{&Input::strengths, "strengths", "yield strengths by thickness, replaces R_e"}
                 .as_arrays()
                 .from_sizes("material", "R_e", "R_e")},
      method_inputs<Input>());

  static constexpr auto results = join(
      Fields{NameField{&Result::section, "section",
                       "lightest adequate section; if none is adequate, the strongest assessed"}
                 .chosen(),
             Field{&Result::q, "q", kg_per_m, "mass per length"}, Field{&Result::mass, "mass", kg, "mass of the bar"},
             Field{&Result::sections, "sections", ratio, "sections of the families within the size limits"}},
      member_results<Result>(),
      Fields{Field{&Result::lack, "lack", ratio,
                   "share of the force beyond the capacity of the strongest section assessed"},
             Field{&Result::carrying, "carrying", ratio, "number of adequate sections"}.limit(1, 1e6).criterion(),
             ListField{&Result::candidates, "candidates", "adequate sections, lightest first"},
             ListField{&Result::lighter, "lighter",
                       "next lighter sections with the reason for rejection, heaviest first"}});

  static bool families_known(const Input& in);
  static FieldFault unknown_family(const Input& in);
  static bool families_once(const Input& in);
  static FieldFault family_twice(const Input& in);
  static bool room_for_one(const Input& in);
  static FieldFault no_room(const Input& in);
  static bool kind_fits(const Input& in);
  static FieldFault kind_of_tubes(const Input& in);
  static bool fibres_known(const Input& in);
  static FieldFault no_fibre(const Input& in);
  static bool strengths_rise(const Input& in);
  static bool one_strength(const Input& in);
  static bool strength_in_tension(const Input& in);
  /// The method that decides: as named, else by what is given.
  static Method method_of(const Input& in);
  static bool needs_of_method(const Input& in);
  static FieldFault missing_for_method(const Input& in);
  static bool one_carries(const Input& in);
  static FieldFault none_carries(const Input& in);
  static Outline outline_of(const Input& in);

  static constexpr auto rules = join(
      std::array{
          Rule<Input>{&families_known, "families", "unknown family: no section of the tables begins with it",
                      &unknown_family},
          Rule<Input>{&families_once, "families", "each family may be named once", &family_twice},
          Rule<Input>{&room_for_one, "h_max, b_max, families", "no section of these families fits h_max and b_max",
                      &no_room},
          Rule<Input>{&kind_fits, "kind, families", "round tubes must be hot_hollow or cold_hollow", &kind_of_tubes},
          Rule<Input>{&fibres_known, "e_y, e_z, e_0y, e_0z, families",
                      "the distance of the extreme fibre of these sections is unknown", &no_fibre},
          Rule<Input>{&strengths_rise, "strengths", "the thicknesses of the strengths must increase"},
          Rule<Input>{&one_strength, "strengths, R_e", "give R_e, or strengths by thickness, not both"},
          Rule<Input>{&strength_in_tension, "N, R_e",
                      "a bar in tension is assessed by its yield strength: give R_e, or a material"},
          Rule<Input>{[](const Input& in) { return is_set(in.N) || is_set(in.P); }, "N, P",
                      "give the force on the bar: N, positive in tension, or P"}},
      held_rules<Input>(),
      std::array{Rule<Input>{&needs_of_method,
                             "method, R_e, sigma_P, a_T, sigma_c, e_y, e_z, e_0y, e_0z, n_st, gamma_M1, gamma_F",
                             "an input of the method is missing", &missing_for_method}},
      method_rules<Input>(), assumption_rules<Input, &method_of>(), eccentricity_rules<Input>(),
      std::array{Rule<Input>{&one_carries, "families, N, P", "no section of these families carries the bar",
                             &none_carries, true}});
  static constexpr std::array meanings = member_meanings;
  static constexpr auto bounds = held_bounds<Input>();
  static constexpr auto modes = member_modes<Input, &outline_of>("u, r_1, r_0, carrying", "R_e, kind");

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::column
