// Straight bevel gears: geometry, forces, pitting and tooth breakage by ANSI/AGMA 2003.
//
// Decides the cones, diameters and tooth heights at the outer end, the forces on both shafts, and the safety factors
// against pitting and tooth breakage. Geometry of the Gleason system with tapered teeth and constant clearance,
// x_2 = -x_1, by the virtual spur gears of Tredgold. Forces act at the mean diameter, those of the rating at the outer
// one. Frame of each shaft: x from its axis towards the mesh, z along it away from the apex. The geometry factors I
// and J are read from charts of the standard and are inputs. Allowable stresses of through-hardened steel of grade 1
// by its hardness, or as given. Not covered: spiral, Zerol and hypoid teeth, load spectra, scuffing, case crushing,
// the hardness ratio factor by formula. Recalled: the maximum velocity, 0.7 for idlers, bounds of I, J
// and the speed, widths from 2 m_et.
#pragma once

#include "calculators/gear/bevel/bounds.hpp"
#include "calculators/gear/bevel/results.hpp"
#include "calculators/gear/bevel/types.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::gear {

struct Bevel : BevelTypes {
  static constexpr auto id = "gear.bevel";
  static constexpr auto title = "Straight bevel gears (ANSI/AGMA 2003)";
  static constexpr auto scope =
      "Geometry, tooth forces, pitting and tooth breakage of straight bevel gears at any shaft angle by ANSI/AGMA "
      "2003, with the geometry factors I and J from its charts as inputs; spiral and hypoid gears are not covered.";
  static constexpr auto source = "[AGMA2003], [KHK-bevel], [Inventor-bevel]";
  static constexpr auto headline = "z {z_1}/{z_2}, m {m_et}";
  static constexpr auto details = "b = {b}, S_H = {S_H1}/{S_H2}, S_F = {S_F1}/{S_F2}|b = {b}";
  static constexpr auto synonyms =
      "bevel gear, straight bevel gear, mitre gear, miter gear, right-angle gear, pitch cone, cone distance, virtual "
      "number of teeth, AGMA 2003, Gleason, Tredgold, bevel pinion, Kegelrad, Kegelradgetriebe, Kegelradpaar, "
      "Teilkegelwinkel, "
      "Ersatzzähnezahl, коническая передача, коническое колесо, прямозубая коническая передача";
  static constexpr auto example = R"([project]
title = "Right-angle drive"

[bevel]
calculator = "gear.bevel"
z_1 = 20
z_2 = 40
m_et = "4 mm"
b = "28 mm"
x_1 = 0.3
h_fP = 1.188
P = "5 kW"
n_1 = "900 rpm"
K_A = 1.25
Q_v = 8
mounting = "one_straddled"
crowning = "crowned"
I = 0.083
J_1 = 0.244
J_2 = 0.2
H_B1 = 300
H_B2 = 280
L_h = "10000 h"
S_Hmin = 1.1
S_Fmin = 1.5
)";

  static bool carries(const Input& in) { return is_set(in.T_1) || is_set(in.P); }
  static bool rates(const Input& in) { return is_set(in.I) || is_set(in.J_1) || is_set(in.J_2); }
  static bool cones_meet(const Input& in);
  static bool face_fits(const Input& in);
  static FieldFault wide_face(const Input& in);
  static constexpr Fields inputs{
      Count{&Input::z_1, "z_1", 6, 500, "number of teeth, gear 1 (pinion)"}.same_as_that_of_source("stages[#].z_1"),
      Count{&Input::z_2, "z_2", 6, 500, "number of teeth, gear 2"}.same_as_that_of_source("stages[#].z_2"),
      Field{&Input::m_et, "m_et", mm, "outer transverse module"}.positive().usually(0.5, 50).same_as_that_of_source(
          "stages[#].m_n"),
      Field{&Input::b, "b", mm, "face width along the pitch cone"}.positive().usually(2, 500),
      Field{&Input::Sigma, "Sigma", deg, "shaft angle"}.within(10, 160).usually(30, 120),
      Field{&Input::alpha, "alpha", deg, "pressure angle"}.within(14.5, 25),
      Field{&Input::x_1, "x_1", ratio, "profile shift coefficient, gear 1; that of gear 2 is its negative"}
          .within(-0.6, 0.6)
          .usually(0, 0.5),
      Field{&Input::h_aP, "h_aP", ratio, "addendum of the basic rack, in modules"}.within(0.7, 1.2),
      Field{&Input::h_fP, "h_fP", ratio, "dedendum of the basic rack, in modules"}.within(0.8, 1.5).usually(1.1, 1.4),
      Field{&Input::T_1, "T_1", N_m,
            "torque on shaft 1, nominal; positive where gear 1 drives, negative where it is driven"}
          .load()
          .at_least_that_of_source("shafts[#].T")
          .with("F_t, F_r1, F_a1")
          .may_be_missing(),
      Field{&Input::P, "P", kW, "nominal power input of gear 1, with n_1, replaces T_1"}
          .load()
          .positive()
          .at_least_that_of_source("shafts[#].P")
          .may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of gear 1"}
          .positive()
          .usually(1, 2e4)
          .near_that_of_source("shafts[#].n")
          .may_be_missing(),
      Choice{&Input::turns, "turns", "direction of rotation of gear 1, viewed towards the apex"}.may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "application factor (AGMA: overload factor K_o; 1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Choice{&Input::idler, "idler", "idler gear (reversed tooth bending)"}.may_be_missing(),
      Field{&Input::bore_1, "bore_1", mm, "bore diameter of gear 1"}.positive().may_be_missing(),
      Field{&Input::bore_2, "bore_2", mm, "bore diameter of gear 2"}.positive().may_be_missing(),
      Count{&Input::Q_v, "Q_v", 5, 11, "transmission accuracy number, AGMA 2003; 5 is the coarsest"}.may_be_missing(),
      Choice{&Input::mounting, "mounting", "mounting of the gears"}.may_be_missing(),
      Choice{&Input::crowning, "crowning", "lengthwise crowning of the teeth"}.may_be_missing(),
      Field{&Input::I, "I", ratio, "geometry factor for pitting, from the chart of AGMA 2003"}
          .within(0.02, 0.25)
          .usually(0.05, 0.13)
          .may_be_missing(),
      Field{&Input::J_1, "J_1", ratio, "geometry factor for bending, gear 1, from the chart of AGMA 2003"}
          .within(0.05, 0.6)
          .usually(0.15, 0.4)
          .may_be_missing(),
      Field{&Input::J_2, "J_2", ratio, "geometry factor for bending, gear 2, from the chart of AGMA 2003"}
          .within(0.05, 0.6)
          .usually(0.15, 0.4)
          .may_be_missing(),
      Field{&Input::H_B1, "H_B1", ratio, "Brinell hardness, gear 1, of through-hardened steel of grade 1"}
          .within(150, 400)
          .usually(180, 400)
          .may_be_missing(),
      Field{&Input::H_B2, "H_B2", ratio, "Brinell hardness, gear 2, of through-hardened steel of grade 1"}
          .within(150, 400)
          .usually(180, 400)
          .may_be_missing(),
      Field{&Input::s_ac1, "s_ac1", MPa, "allowable contact stress number, gear 1, replaces that by H_B1"}
          .positive()
          .usually(200, 1750)
          .customarily_at_most(1750)
          .may_be_missing(),
      Field{&Input::s_ac2, "s_ac2", MPa, "allowable contact stress number, gear 2, replaces that by H_B2"}
          .positive()
          .usually(200, 1750)
          .customarily_at_most(1750)
          .may_be_missing(),
      Field{&Input::s_at1, "s_at1", MPa, "allowable bending stress number, gear 1, replaces that by H_B1"}
          .positive()
          .usually(15, 280)
          .customarily_at_most(280)
          .may_be_missing(),
      Field{&Input::s_at2, "s_at2", MPa, "allowable bending stress number, gear 2, replaces that by H_B2"}
          .positive()
          .usually(15, 280)
          .customarily_at_most(280)
          .may_be_missing(),
      Field{&Input::E_1, "E_1", GPa, "modulus of elasticity, gear 1"}.positive().usually(80, 220),
      Field{&Input::E_2, "E_2", GPa, "modulus of elasticity, gear 2"}.positive().usually(80, 220),
      Field{&Input::nu_1, "nu_1", ratio, "Poisson's ratio, gear 1"}.within(0, 0.5),
      Field{&Input::nu_2, "nu_2", ratio, "Poisson's ratio, gear 2"}.within(0, 0.5),
      Field{&Input::N, "N", ratio, "required load cycles of gear 1"}.at_least(1).usually(1e3, 1e10).may_be_missing(),
      Field{&Input::L_h, "L_h", hour, "required life, replaces N"}
          .positive()
          .usually(100, 3e5)
          .customarily_at_least(100)
          .may_be_missing(),
      Choice{&Input::service, "service", "service, for the stress cycle factor in bending"}.may_be_missing(),
      Field{&Input::R, "R", ratio, "reliability"}.within(0.9, 0.9999).usually(0.99, 0.9999),
      Field{&Input::T_G, "T_G", scale_of_heat, "operating temperature of the gear blanks; omitted: up to 121 °C"}
          .positive()
          .may_be_missing(),
      Field{&Input::C_H, "C_H", ratio, "hardness ratio factor, gear 2, from the chart of AGMA 2003"}.within(1, 1.16),
      Field{&Input::S_Hmin, "S_Hmin", ratio, "required safety factor against pitting"}
          .at_least(1)
          .usually(1, 2)
          .may_be_missing()
          .factor(),
      Field{&Input::S_Fmin, "S_Fmin", ratio, "required safety factor against tooth breakage"}
          .at_least(1)
          .usually(1.2, 3)
          .may_be_missing()
          .factor()};
  static constexpr auto results = bevel_results;

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.z_1 <= in.z_2; }, "z_1, z_2",
                  "gear 1 is the pinion and must not have more teeth than gear 2; if gear 2 drives, give T_1 negative"},
      Rule<Input>{&cones_meet, "Sigma, z_1, z_2",
                  "a pitch cone angle would exceed 90° at this shaft angle: reduce Sigma, or the gear ratio"},
      Rule<Input>{&face_fits, "b, m_et, z_1, z_2, Sigma",
                  "the face width must be less than half the outer cone distance", &wide_face},
      Rule<Input>{[](const Input& in) { return !(in.bore_1 >= in.m_et * in.z_1); }, "bore_1, m_et, z_1",
                  "the bore of gear 1 must be less than its pitch diameter m_et z_1"},
      Rule<Input>{[](const Input& in) { return !(in.bore_2 >= in.m_et * in.z_2); }, "bore_2, m_et, z_2",
                  "the bore of gear 2 must be less than its pitch diameter m_et z_2"},
      Rule<Input>{[](const Input& in) { return in.h_fP - in.h_aP >= 0.1 - 1e-9; }, "h_fP, h_aP",
                  "the dedendum must exceed the addendum by at least 0.1, the tip clearance in modules"},
      Rule<Input>{[](const Input& in) { return !(is_set(in.T_1) && is_set(in.P)); }, "T_1, P",
                  "give the load as T_1 or as P, not both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{[](const Input& in) { return !rates(in) || (carries(in) && is_set(in.n_1)); },
                  "I, J_1, J_2, T_1, P, n_1", "the rating needs a load (T_1, or P) and the speed n_1"},
      Rule<Input>{[](const Input& in) { return !rates(in) || !(abs(in.T_1) <= 0.0 * N_m); }, "T_1, I, J_1, J_2",
                  "the rating needs a torque other than zero: omit I, J_1 and J_2 of unloaded gears"},
      Rule<Input>{[](const Input& in) { return !rates(in) || is_set(in.N) != is_set(in.L_h); }, "I, J_1, J_2, N, L_h",
                  "the rating needs the life: give either N or L_h"},
      Rule<Input>{[](const Input& in) {
                    const bool one = is_set(in.H_B1) || is_set(in.s_ac1), two = is_set(in.H_B2) || is_set(in.s_ac2);
                    return !is_set(in.I) || (one && two);
                  },
                  "I, H_B1, H_B2, s_ac1, s_ac2", "pitting needs H_B1 or s_ac1, and H_B2 or s_ac2"},
      Rule<Input>{[](const Input& in) { return !is_set(in.J_1) || is_set(in.H_B1) || is_set(in.s_at1); },
                  "J_1, H_B1, s_at1", "tooth breakage of gear 1 needs H_B1 or s_at1"},
      Rule<Input>{[](const Input& in) { return !is_set(in.J_2) || is_set(in.H_B2) || is_set(in.s_at2); },
                  "J_2, H_B2, s_at2", "tooth breakage of gear 2 needs H_B2 or s_at2"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S_Hmin) || is_set(in.I); }, "S_Hmin, I",
                  "the safety factor S_Hmin needs the geometry factor I"},
      Rule<Input>{[](const Input& in) { return !is_set(in.S_Fmin) || is_set(in.J_1) || is_set(in.J_2); },
                  "S_Fmin, J_1, J_2", "the safety factor S_Fmin needs a geometry factor J_1 or J_2"}};

  static constexpr std::array bounds{Bound<Input>{"s_ac1", "the hardness H_B1, plus 10 %",
                                                  [](const Input& in) { return bevel::most_contact_number(in.H_B1); }},
                                     Bound<Input>{"s_at1", "the hardness H_B1, plus 10 %",
                                                  [](const Input& in) { return bevel::most_bending_number(in.H_B1); }},
                                     Bound<Input>{"s_ac2", "the hardness H_B2, plus 10 %",
                                                  [](const Input& in) { return bevel::most_contact_number(in.H_B2); }},
                                     Bound<Input>{"s_at2", "the hardness H_B2, plus 10 %",
                                                  [](const Input& in) { return bevel::most_bending_number(in.H_B2); }},
                                     Bound<Input>{"I", "the chart for these teeth, plus 15 %", &bevel::most_I},
                                     Bound<Input>{"J_1", "the chart for these teeth, plus 15 %", &bevel::most_J_1},
                                     Bound<Input>{"J_2", "the chart for these teeth, plus 25 %", &bevel::most_J_2},
                                     Bound<Input>{"n_1", "straight teeth of this accuracy", &bevel::most_speed}};

  static constexpr bool turns = true;
  static constexpr std::array senses{SenseClaim{"T_1, P", "idler", "none, gear_1, gear_2", "both"}};
  static Applies loaded(const Input& in) { return where(carries(in)); }
  static Applies rated(const Input& in) { return where(rates(in)); }
  static constexpr auto for_pitting =
      "give S_Hmin, with I from the chart, hardness (H_B1, H_B2) or s_ac1 and s_ac2, and the life (L_h or N)";
  static constexpr auto for_bending =
      "give S_Fmin, with J_1 and J_2 from the chart, hardness (H_B1, H_B2) or s_at1 and s_at2, and the life (L_h or N)";
  static constexpr std::array modes{
      Mode<Input>{"pitting_1", "pitting, gear 1", &loaded}.judged_by("u_H1, N_1").asking(for_pitting),
      Mode<Input>{"pitting_2", "pitting, gear 2", &loaded}.judged_by("u_H2, N_2").asking(for_pitting),
      Mode<Input>{"root_1", "tooth breakage, gear 1", &loaded}.judged_by("u_F1, N_1").asking(for_bending),
      Mode<Input>{"root_2", "tooth breakage, gear 2", &loaded}.judged_by("u_F2, N_2").asking(for_bending),
      Mode<Input>{"dynamic", "dynamic tooth load", &rated}.judged_by("x_v"),
      Mode<Input>{"contact", "contact ratio", &always<Input>}.judged_by("eps_v").of_shape(),
      Mode<Input>{"undercut", "undercut", &always<Input>}.judged_by("x_free").of_shape(),
      Mode<Input>{"pointed", "tip thickness", &always<Input>}.judged_by("s_a").of_shape(),
      Mode<Input>{"width", "face width", &always<Input>}.judged_by("x_R, x_m").of_shape(),
      Mode<Input>{"rim_1", "rim thickness, gear 1", &unseen<Input>}.judged_by("m_R1").wanting("bore_1").special(),
      Mode<Input>{"rim_2", "rim thickness, gear 2", &unseen<Input>}.judged_by("m_R2").wanting("bore_2").special(),
      Mode<Input>{"mounting", "displacement of the gears by deflection of shafts and housing", &unseen<Input>}
          .special(),
      Mode<Input>{"backlash", "backlash", &unseen<Input>}.special(),
      Mode<Input>{"overload", "tooth overload at peak torque", &unseen<Input>}.special(),
      Mode<Input>{"scuffing", "scuffing", &unseen<Input>}.special(),
      Mode<Input>{"case_crushing", "case crushing", &unseen<Input>}.special(),
      Mode<Input>{"wear", "wear of the tooth flanks", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::gear
