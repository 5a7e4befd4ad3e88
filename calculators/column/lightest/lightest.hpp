// The lightest section of a family, or of several, that carries a compressed bar.
//
// Every row of the section tables of these families is judged as column.buckling judges it, by the method that is
// chosen; those that pass are ranked by their mass, those that are lighter say why they fail, and the best one is
// worked out whole. The strength of a material falls with the thickness: all are judged with that of the thickest one
// up to the section found, which is on the safe side for the others.
// Not covered: what column.buckling does not cover, and so torsional buckling, which can decide for channels and
// angles.
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
  static constexpr auto title = "Lightest section of a compressed bar";
  static constexpr auto scope =
      "Ranked list of the sections of one family or several that carry a compressed bar, the lightest first, with the "
      "reason why lighter ones fail; the best one with its whole calculation by column.buckling, and what that does "
      "not cover: torsional buckling of channels and angles, sections of class 4, holes of a bar in tension. With a "
      "material each section has the yield strength of its own thickness; those thicker than it is given for are not "
      "judged.";
  static constexpr auto source = Buckling::source;
  static constexpr auto headline = "{section}";
  static constexpr auto subject = "buckling";
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
      Fields{ListField{&Input::families, "families", "families of the section tables to choose from"}.as_arrays()},
      held_inputs<Input>(),
      Fields{Choice{&Input::kind, "kind", "kind of the sections whose table leaves it open: of round tubes"}
                 .may_be_missing(),
             Field{&Input::h_max, "h_max", mm, "largest height that there is room for"}.positive().may_be_missing(),
             Field{&Input::b_max, "b_max", mm, "largest width that there is room for"}.positive().may_be_missing()},
      material_inputs<Input>(),
      Fields{ListField{&Input::strengths, "strengths", "yield strengths by thickness, in place of R_e alone"}
                 .as_arrays()
                 .from_sizes("material", "R_e", "R_e")},
      method_inputs<Input>());

  static constexpr auto results = join(
      Fields{NameField{&Result::section, "section",
                       "lightest section; the strongest of those judged where none carries the bar"}
                 .chosen(),
             Field{&Result::q, "q", kg_per_m, "its mass per length"},
             Field{&Result::mass, "mass", kg, "mass of the bar"},
             Field{&Result::sections, "sections", ratio, "sections of these families that there is room for"}},
      member_results<Result>(),
      Fields{Field{&Result::lack, "lack", ratio, "part of the force that even the strongest judged does not carry"},
             Field{&Result::carrying, "carrying", ratio, "sections that carry the bar"}.limit(1, 1e6).criterion(),
             ListField{&Result::candidates, "candidates", "sections that carry the bar, lightest first"},
             ListField{&Result::lighter, "lighter", "the next lighter ones and why they fail, heaviest first"}});

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
  static bool needs_of_method(const Input& in);
  static FieldFault missing_for_method(const Input& in);
  static bool one_carries(const Input& in);
  static FieldFault none_carries(const Input& in);
  static Outline outline_of(const Input& in);

  static constexpr auto rules = join(
      std::array{
          Rule<Input>{&families_known, "families", "there is no such family in the section tables", &unknown_family},
          Rule<Input>{&families_once, "families", "a family is named twice", &family_twice},
          Rule<Input>{&room_for_one, "h_max, b_max, families", "there is room for no section of these families",
                      &no_room},
          Rule<Input>{&kind_fits, "kind, families", "round tubes are hot_hollow or cold_hollow", &kind_of_tubes},
          Rule<Input>{&fibres_known, "e_y, e_z, families", "the extreme fibre of these sections is not known",
                      &no_fibre},
          Rule<Input>{&strengths_rise, "strengths", "the thicknesses of the strengths must rise"},
          Rule<Input>{&one_strength, "strengths, R_e", "give R_e, or strengths by thickness, never both"},
          Rule<Input>{&strength_in_tension, "N, R_e",
                      "a bar in tension is judged by its yield strength: give R_e, or a material"},
          Rule<Input>{[](const Input& in) { return is_set(in.N) || is_set(in.P); }, "N, P",
                      "give the force that the bar shall carry: N, positive in tension, or P"}},
      held_rules<Input>(),
      std::array{Rule<Input>{&needs_of_method, "method, R_e, sigma_P, a_T, sigma_c, e_y, e_z, n_st, gamma_M1, gamma_F",
                             "something is missing that the method needs", &missing_for_method}},
      method_rules<Input>(), eccentricity_rules<Input>(),
      std::array{Rule<Input>{&one_carries, "families, N, P", "no section of these families carries the bar",
                             &none_carries, true}});
  static constexpr std::array meanings = member_meanings;
  static constexpr auto bounds = held_bounds<Input>();
  static constexpr auto modes = member_modes<Input, &outline_of>("u, r_1, r_0, carrying", "R_e, kind");

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::column
