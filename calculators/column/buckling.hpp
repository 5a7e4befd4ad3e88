// A compressed bar against buckling, by every method that its inputs allow, side by side.
//
// Decides the critical stress and the allowable load about both axes, by Euler, Tetmajer-Yasinsky, Johnson, Rankine,
// the secant formula (with an eccentricity, a bow or both), EN 1993-1-1 6.3.1, AISC 360 E3 and SP 16.13330; one of them
// is chosen for the check. Critical stresses hold no safety; each allowable load holds the safety of its own method.
// Uniform straight bar, central load (but for the secant formula), flexural buckling about the principal axes y and z.
// Sign: N is positive in tension, as mechanisms give it; P is positive in compression. Both may be series. In tension
// the stress N/A is compared with the yield strength, with a safety factor of its own. Channels, tees and angles of
// equal legs are assessed for torsional-flexural buckling too. Not covered: the net section of a bar in tension,
// torsional buckling of other open sections, sections of class 4, built-up and tapered bars, transverse loads, biaxial
// eccentricity.
#pragma once

#include "calculators/column/bounds.hpp"
#include "calculators/column/buckling_input.hpp"
#include "calculators/column/member/modes.hpp"
#include "calculators/column/member/result.hpp"
#include "calculators/column/member/rules.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/form.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::column {

struct Buckling {
  static constexpr auto id = "column.buckling";
  static constexpr auto title = "Column buckling";
  static constexpr auto scope =
      "Slenderness of a uniform bar about both axes, critical stress by Euler, Tetmajer-Yasinsky, Johnson, "
      "Rankine, secant formula, EN 1993-1-1, AISC 360 and SP 16, and the allowable load by each method, each with its "
      "own safety factor; torsional-flexural buckling of channels, tees and angles of equal legs; tension is assessed "
      "by "
      "N/A on the gross section; torsional buckling of other open sections, class 4 sections and transverse loads are "
      "not covered.";
  static constexpr auto source =
      "[B25], [Johnson], [Rankine], [Gere], [Case-Chilver], [EN1993-1-1-buckling], [AISC360], [SP16], [EN1993-1-1-TF], "
      "[AISC360-E4]";
  static constexpr auto headline = "{section}|d = {d}|A = {A}";
  static constexpr auto details = "slenderness lambda = {lambda} about {axis}";
  static constexpr auto subject = "buckling";
  static constexpr auto synonyms =
      "column, strut, buckling, eccentric load, initial bow, crooked bar, Euler, Johnson, Tetmajer, Yasinsky, Rankine, "
      "secant formula, slenderness, "
      "effective length, EN 1993-1-1, AISC 360, SP 16, compression member, Knickung, Knickstab, Knicklänge, "
      "Schlankheit, Stabilität, flexural buckling, critical load, Euler load, Eulerlast, устойчивость, "
      "продольный изгиб, сжатый стержень, гибкость, Эйлер, Ясинский";
  static constexpr auto example = R"([project]
title = "Piston rod"

[rod]
calculator = "column.buckling"
P = "40 kN"
l = "900 mm"
d = "45 mm"
ends = "fixed_free"
E = "210 GPa"
R_e = "340 MPa"
sigma_P = "270 MPa"
method = "euler"
n_st = 3
)";

  using Input = BucklingInput;
  static constexpr auto inputs =
      join(held_inputs<Input>(), section_inputs<Input>(), material_inputs<Input>(), derived_section_inputs<Input>(),
           twisting_inputs<Input>(),
           Fields{Field<Input, Length>{
               &Input::l_T, "l_T", mm,
               "distance of the supports against twisting; omitted: l, or 2 l for a free or sway end"}
                      .positive()
                      .usually(10, 1e5)
                      .may_be_missing()},
           method_inputs<Input>());

  using Result = MemberResult;
  static constexpr auto results = member_results<Result>();

  static bool section_given(const Input& in);
  static bool radii_fit(const Input& in);
  static bool needs_of_method(const Input& in);
  static bool extreme_fibre_known(const Input& in);
  static FieldFault section_missing(const Input& in);
  static FieldFault missing_for_method(const Input& in);
  static Outline outline_of(const Input& in);
  static double amount(const Input& in) { return in_si(area_of(in)); }

  static constexpr auto rules = join(
      held_rules<Input>(), section_rules<Input, &section_given, &section_missing, &radii_fit>(),
      std::array{
          Rule<Input>{&extreme_fibre_known, "e_y, e_z, e_0y, e_0z, c_y, c_z, h, b, d, kind",
                      "an eccentricity or a bow needs the distance of the extreme fibre: c_y (or h) with e_y and e_0y, "
                      "c_z (or b) with e_z and e_0z; of a channel about z, a tee about y and an angle c itself, as it "
                      "is not half the side"},
          Rule<Input>{&needs_of_method,
                      "method, R_e, sigma_P, a_T, sigma_c, e_y, e_z, e_0y, e_0z, n_st, gamma_M1, gamma_F, kind, "
                      "curve_y, curve_z, "
                      "A, h, b, t_f",
                      "an input of the method is missing", &missing_for_method}},
      method_rules<Input>(), assumption_rules<Input, &method_of>(), eccentricity_rules<Input>());
  static constexpr std::array meanings = member_meanings;
  static double whole_twisting_length(const Input& in);
  static double most_torsion_constant(const Input& in);
  static double most_warping_constant(const Input& in);
  static double least_shear_centre(const Input& in);
  static constexpr auto bounds =
      join(held_bounds<Input>(), curve_bounds<Input>(), tension_bounds<Input>(),
           std::array{Bound<Input>{"l_T", "l", &whole_twisting_length}.least(),
                      Bound<Input>{"I_t", "1.4 times that of the walls", &most_torsion_constant},
                      Bound<Input>{"I_w", "1.2 times that of the walls", &most_warping_constant},
                      Bound<Input>{"y_M", "0.85 times that of the walls", &least_shear_centre}.least()});
  static constexpr auto modes = member_modes<Input, &outline_of>("u, r_1, r_0", "R_e, kind, h, b, t_f, t_w");

  static constexpr std::array forms{
      Form{"P, l, d, ends, E, sigma_P, method = euler, n_st", "F, A, lambda, sigma_cr, P_all, u, r_lambda, r_1"}};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  /// The same of a bar that something bends: then a part of its walls is pressed in tension too.
  template <class Tracer>
  static Result judge(const Input& in, bool is_bent, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::column
