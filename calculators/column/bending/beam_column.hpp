// A compressed bar that is bent about both axes: a column of a frame.
//
// Decides the resistance of the section under N, M_y and M_z, flexural and lateral-torsional buckling, and their
// interaction, by EN 1993-1-1:2005, 6.2.9 and 6.3.3 with annex B (method 2), or by AISC 360, chapters F and H1
// (allowable strength). End moments, a load evenly distributed over the length and a force at mid-length act in both
// planes; moments and loads are positive where they bend the bar to the same side. The moments are those of the frame:
// of a bar whose ends sway they include the sway of second order, the bending of the bar between its ends is added
// here. Doubly symmetric I sections, hollow sections, and solid bars (EN). The ends are held against twisting. Not
// covered: sections of class 4, sections of one symmetry or none, torque, changing sections.
#pragma once

#include "calculators/column/bending/input.hpp"
#include "calculators/column/bending/result.hpp"
#include "calculators/column/buckling.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/figure/figure.hpp"

#include <vector>

namespace loadpath::column {

struct BeamColumn {
  static constexpr auto id = "column.beam_column";
  static constexpr auto title = "Column under axial force and bending about both axes";
  static constexpr auto scope =
      "Interaction of axial force with bending about both axes, of end moments and transverse loads, with flexural "
      "and lateral-torsional buckling, by EN 1993-1-1 6.3.3 with annex B or by AISC 360 H1, for doubly symmetric I "
      "sections, hollow sections and solid bars; moments of sway frames include the second-order sway; class 4 "
      "sections, "
      "channels, tees, angles and torque are not covered.";
  static constexpr auto source = "[EN1993-1-1-bending], [EN1993-1-1-buckling], [EN1993-1-1-LTB], [AISC360-bending]";
  static constexpr auto headline = "{section}|d = {d}|A = {A}";
  static constexpr auto subject = "strength and buckling";
  static constexpr auto synonyms =
      "beam-column, frame column, combined compression and bending, biaxial bending, interaction, EN 1993-1-1 6.3.3, "
      "annex B, k_yy, lateral-torsional buckling, M_cr, chi_LT, AISC 360 H1-1, B1 amplifier, Rahmenstütze, "
      "Biegung und Normalkraft, Biegedrillknicken, Kippen, внецентренно сжатая колонна, сжатие с изгибом";
  static constexpr auto example = R"([project]
title = "Column of a braced frame"

[column]
calculator = "column.beam_column"
P = "600 kN"
M_y_1 = "60 kN*m"
M_y_2 = "-20 kN*m"
M_z = "5 kN*m"
l = "4 m"
ends = "pinned_pinned"
section = "HEB 200"
E = "210 GPa"
R_e = "235 MPa"
method = "ec3"
gamma_M1 = 1
gamma_F = 1
)";

  using Input = BeamColumnInput;
  static constexpr auto inputs = join(
      held_inputs<Input>(),
      Fields{Field{&Input::M_y, "M_y", N_m,
                   "bending moment about y, uniform or of unknown distribution; replaces M_y_1, M_y_2, q_z and F_z"}
                 .load()
                 .may_be_missing(),
             Field{&Input::M_y_1, "M_y_1", N_m, "end moment about y at the start, with its sign"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::M_y_2, "M_y_2", N_m, "end moment about y at the end; same sign as M_y_1: bent to one side"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::q_z, "q_z", N_per_mm, "distributed transverse load along z, bends about y"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::F_z, "F_z", kN, "transverse force along z at mid-length, bends about y"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::M_z, "M_z", N_m,
                   "bending moment about z, uniform or of unknown distribution; replaces M_z_1, M_z_2, q_y and F_y"}
                 .load()
                 .may_be_missing(),
             Field{&Input::M_z_1, "M_z_1", N_m, "end moment about z at the start, with its sign"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::M_z_2, "M_z_2", N_m, "end moment about z at the end; same sign as M_z_1: bent to one side"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::q_y, "q_y", N_per_mm, "distributed transverse load along y, bends about z"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::F_y, "F_y", kN, "transverse force along y at mid-length, bends about z"}
                 .load()
                 .keeps_sign()
                 .may_be_missing(),
             Field{&Input::z_g, "z_g", mm,
                   "from the shear centre to the transverse load along z, positive on the side where it acts; omitted: "
                   "half the height"}
                 .may_be_missing(),
             Field{&Input::l_LT, "l_LT", mm,
                   "distance of the supports against twisting and lateral displacement; omitted: l"}
                 .positive()
                 .may_be_missing(),
             Field{&Input::C_1_set, "C_1_set", ratio,
                   "moment distribution factor of lateral-torsional buckling (aisc: C_b); omitted: from the moments"}
                 .within(1, 3)
                 .may_be_missing()},
      section_inputs<Input>(),
      Fields{Field{&Input::W_pl_y, "W_pl_y", mm3, "plastic section modulus about y; omitted: from the plates"}
                 .positive()
                 .from("section", "W_pl_y")
                 .where_it_has(),
             Field{&Input::W_pl_z, "W_pl_z", mm3, "plastic section modulus about z; omitted: from the plates"}
                 .positive()
                 .from("section", "W_pl_z")
                 .where_it_has(),
             Field<Input, SecondMoment>{&Input::I_t, "I_t", mm4, "torsion constant; omitted: from the plates"}
                 .positive()
                 .from("section", "I_t")
                 .where_it_has(),
             Field<Input, Warping>{&Input::I_w, "I_w", mm6, "warping constant; omitted: from the plates"}
                 .positive()
                 .from("section", "I_w")
                 .where_it_has()},
      strength_inputs<Input>(), derived_section_inputs<Input>(), method_choice<Input>(), code_inputs<Input>(),
      Fields{Choice{&Input::twist_curves, "twist_curves", "curves of lateral-torsional buckling of EN 1993-1-1"}
                 .may_be_missing(),
             Choice{&Input::analysis, "analysis", "moments of first or second order"}.may_be_missing(),
             Field{&Input::gamma_M0, "gamma_M0", ratio,
                   "partial factor of the section, EN 1993-1-1 and its national annex"}
                 .at_least(1)
                 .usually(1, 1.2)
                 .factor(),
             Field{&Input::Omega_b, "Omega_b", ratio, "safety factor of bending, AISC 360, F1"}
                 .at_least(1)
                 .usually(1.5, 2)
                 .customarily_at_least(1.5)
                 .factor()});

  using Result = BeamColumnResult;
  static constexpr auto results = beam_column_results;

  static double amount(const Input& in) { return in_si(area_of(in)); }
  static bool force_given(const Input& in);
  static bool fits_shape(const Input& in);
  static bool plastic_fits(const Input& in);
  static FieldFault other_plastic(const Input& in);
  static bool by_a_code(const Input& in);
  static FieldFault not_of_code(const Input& in);
  static bool free_end_is_unloaded(const Input& in);
  static Applies bent(const Input& in);
  static Applies loaded(const Input& in);
  static Applies turning_over(const Input& in);
  static Applies twisting(const Input& in);
  static Applies walls_pressed(const Input& in);
  static double full_length(const Input& in);
  static double factor_of_moments(const Input& in);
  static bool load_on_section(const Input& in) { return !(in.z_g < -0.5000001 * (is_set(in.d) ? in.d : in.h)); }

  static constexpr auto rules = join(
      held_rules<Input>(),
      section_rules<Input, &Buckling::section_given, &Buckling::section_missing, &Buckling::radii_fit>(),
      std::array{
          Rule<Input>{&force_given, "N, P", "give the normal force N, positive in tension, or P in compression"},
          Rule<Input>{[](const Input& in) { return is_set(in.R_e); }, "R_e",
                      "give the yield strength R_e, or a material"},
          Rule<Input>{[](const Input& in) { return is_set(in.M_y_1) == is_set(in.M_y_2); }, "M_y_1, M_y_2",
                      "give both end moments about y (0 at a hinge), or M_y"},
          Rule<Input>{[](const Input& in) { return is_set(in.M_z_1) == is_set(in.M_z_2); }, "M_z_1, M_z_2",
                      "give both end moments about z (0 at a hinge), or M_z"},
          Rule<Input>{[](const Input& in) {
                        return !is_set(in.M_y) || !(is_set(in.M_y_1) || is_set(in.q_z) || is_set(in.F_z));
                      },
                      "M_y, M_y_1, M_y_2, q_z, F_z", "M_y replaces the end moments and the loads along z"},
          Rule<Input>{[](const Input& in) {
                        return !is_set(in.M_z) || !(is_set(in.M_z_1) || is_set(in.q_y) || is_set(in.F_y));
                      },
                      "M_z, M_z_1, M_z_2, q_y, F_y", "M_z replaces the end moments and the loads along y"},
          Rule<Input>{&by_a_code, "method, kind, E", "bending with compression is assessed by ec3 or aisc",
                      &not_of_code},
          Rule<Input>{&fits_shape, "kind, d, h, b, t_f, t_w, A, I_y, I_z",
                      "the section must be a doubly symmetric I, a hollow section or (ec3) a solid bar, with its kind "
                      "and its dimensions h, b, t_f and t_w, or d and t_w"},
          Rule<Input>{&plastic_fits, "W_pl_y, W_pl_z, h, b, t_f, t_w",
                      "the plastic section moduli must be those of the plates", &other_plastic},
          Rule<Input>{&free_end_is_unloaded, "ends_z, ends, beta_z, l_LT, z_g, q_z, F_z",
                      "of a bar with a free or sway end, or with l_LT, a load above the shear centre is not covered: "
                      "z_g = \"0 mm\" if it acts there; in place of l_LT give supports_z"},
          Rule<Input>{&load_on_section, "z_g, h, d",
                      "the transverse load acts below the section: z_g is at least -h/2"},
          Rule<Input>{&of<Input, &Buckling::needs_of_method>,
                      "method, R_e, sigma_P, a_T, n_st, gamma_M1, gamma_F, kind, curve_y, curve_z, A, h, b, t_f",
                      "an input of the method is missing", &of<Input, &Buckling::missing_for_method>}},
      method_rules<Input>(), assumption_rules<Input, &method_of>());
  static constexpr auto bounds =
      join(held_bounds<Input>(), curve_bounds<Input>(),
           std::array{Bound<Input>{"l_LT", "l", &full_length}.least(),
                      Bound<Input>{"C_1_set", "the moments along the bar", &factor_of_moments}});

  static constexpr std::array modes{
      Mode<Input>{"section", "section under axial force and bending", &loaded}.judged_by("u_s, u_H"),
      Mode<Input>{"buckling", "flexural buckling about y and z", &compressed<Input>}.judged_by("u"),
      Mode<Input>{"bent", "bending and axial compression", &bent}.judged_by("u_y, u_z, u_H"),
      Mode<Input>{"lateral_torsional", "lateral-torsional buckling", &turning_over}.judged_by("u_LT"),
      Mode<Input>{"torsional", "torsional buckling", &twisting}.judged_by("u_T"),
      Mode<Input>{"slenderness", "slenderness limit", &compressed<Input>}.judged_by("r_lambda").at_any_load(),
      Mode<Input>{"local", "local buckling (class 3 limit)", &walls_pressed}.judged_by("r_class"),
      Mode<Input>{"shear", "shear force in the webs", &bent}.judged_by("x_V"),
      Mode<Input>{"net_section", "net section rupture (holes)", &pulled_at_holes<Input>}.assessed_additionally_in(
          "pin.lug"),
      Mode<Input>{"fatigue", "fatigue", &unseen<Input>}.in_service().assessed_additionally_in(
          "fatigue.life, fatigue.history"),
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"weight", "bending due to self-weight", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::column
