// Crossed helical (screw) gears: geometry, sliding, efficiency, self-locking, forces and load value.
//
// Decides the diameters and centre distance, the path of contact and the face widths that it needs, the sliding along
// the teeth, the efficiency in both directions and the forces on both shafts. Helix angles are positive for right-hand
// teeth; their sum is the shaft angle. x_2 = -x_1: the reference cylinders are the working pitch cylinders. Gear 1
// drives. Friction acts along the teeth. Frame of each shaft: x from its axis to that of the mate, z along it; z of
// gear 2 is z of gear 1 turned by Sigma towards y of gear 1. Wear and pitting by the load value of Roloff/Matek, from
// memory; allowable values are charts of the books and are inputs, as is the coefficient of friction. Not covered:
// other profile shift, tooth breakage, which the point contact leaves open, scuffing and heat.
#pragma once

#include "calculators/gear/crossed/results.hpp"
#include "calculators/gear/crossed/types.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <vector>

namespace loadpath::gear {

struct Crossed : CrossedTypes {
  static constexpr auto id = "gear.crossed";
  static constexpr auto title = "Crossed helical gears (screw gears)";
  static constexpr auto scope =
      "Geometry, sliding, efficiency, self-locking and forces of crossed helical gears; wear and pitting by a load "
      "value with its allowable value as an input; tooth breakage and heat are not covered.";
  static constexpr auto source = "[SDP-SI-crossed], [Roloff-crossed], [Spiral-gears]";
  static constexpr auto headline = "z {z_1}/{z_2}, m {m_n}";
  static constexpr auto details =
      "b_1 = {b_1}, beta_1 = {beta_1}, beta_2 = {beta_2}, efficiency {eta}, centre distance {a}";
  static constexpr auto synonyms =
      "crossed helical gear, screw gear, spiral gear, skew gear, crossed axes, shaft angle, sliding velocity, "
      "self-locking, Schraubradgetriebe, Schraubwälzgetriebe, винтовая передача, "
      "винтовая зубчатая передача";
  static constexpr auto example = R"([project]
title = "Crossed helical gears of a small drive"

[gears]
calculator = "gear.crossed"
z_1 = 20
z_2 = 40
m_n = "2 mm"
beta_1 = "45 deg"
beta_2 = "45 deg"
b_1 = "20 mm"
mu = 0.06
P = "0.25 kW"
n_1 = "1000 rpm"
C_adm = "2 MPa"
)";

  static bool carries(const Input& in) { return is_set(in.T_1) || is_set(in.P) || is_set(in.T_2); }
  static bool drives(const Input& in);
  static bool crosses(const Input& in);
  static constexpr Fields inputs{
      Count{&Input::z_1, "z_1", 5, 500, "number of teeth, gear 1, which drives"}.same_as_that_of_source(
          "stages[#].z_1"),
      Count{&Input::z_2, "z_2", 5, 500, "number of teeth, gear 2"}.same_as_that_of_source("stages[#].z_2"),
      Field{&Input::m_n, "m_n", mm, "normal module"}.positive().usually(0.3, 20).same_as_that_of_source(
          "stages[#].m_n"),
      Field{&Input::beta_1, "beta_1", deg, "helix angle, gear 1; positive for right-hand teeth"}.within(-75, 75),
      Field{&Input::beta_2, "beta_2", deg, "helix angle, gear 2; beta_1 + beta_2 is the shaft angle"}.within(-75, 75),
      Field{&Input::b_1, "b_1", mm, "face width, gear 1"}.positive().usually(2, 300),
      Field{&Input::b_2, "b_2", mm, "face width, gear 2; omitted: that of gear 1"}
          .positive()
          .usually(2, 300)
          .may_be_missing(),
      Field{&Input::alpha_n, "alpha_n", deg, "normal pressure angle"}.within(14.5, 30),
      Field{&Input::x_1, "x_1", ratio, "profile shift coefficient, gear 1; that of gear 2 is its negative"}
          .within(-0.6, 0.6)
          .usually(0, 0.5),
      Field{&Input::h_aP, "h_aP", ratio, "addendum of the basic rack, in normal modules"}.within(0.7, 1.2),
      Field{&Input::h_fP, "h_fP", ratio, "dedendum of the basic rack, in normal modules"}.within(0.8, 1.5).usually(1.1,
                                                                                                                   1.4),
      Field{&Input::mu, "mu", ratio, "coefficient of friction along the teeth, from the chart of a source by v_s"}
          .within(0, 0.3)
          .usually(0.02, 0.15),
      Field{&Input::T_1, "T_1", N_m, "torque of gear 1, which drives, nominal"}
          .load()
          .positive()
          .at_least_that_of_source("shafts[#].T")
          .with("F_t1|F_t2, F_a1|F_a2, F_r")
          .may_be_missing(),
      Field{&Input::T_2, "T_2", N_m, "torque of gear 2, nominal, replaces T_1"}
          .load()
          .positive()
          .with("F_t1|F_t2, F_a1|F_a2, F_r")
          .may_be_missing(),
      Field{&Input::P, "P", kW, "nominal power of gear 1, with n_1, replaces T_1"}
          .load()
          .positive()
          .at_least_that_of_source("shafts[#].P")
          .may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of gear 1"}
          .positive()
          .usually(1, 2e4)
          .near_that_of_source("shafts[#].n")
          .may_be_missing(),
      Choice{&Input::turns, "turns", "direction of rotation of gear 1, viewed from +z"}.may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Choice{&Input::locking, "locking", "self-locking"}.may_be_missing(),
      Field{&Input::C_adm, "C_adm", MPa, "allowable load value at v_s, from the chart of a source for the materials"}
          .positive()
          .usually(0.1, 10)
          .customarily_at_most(10)
          .may_be_missing(),
      Field{&Input::bore_1, "bore_1", mm, "bore diameter of gear 1"}.positive().may_be_missing(),
      Field{&Input::bore_2, "bore_2", mm, "bore diameter of gear 2"}.positive().may_be_missing()};
  static constexpr auto results = crossed_results;

  static constexpr std::array rules{
      Rule<Input>{&crosses, "beta_1, beta_2",
                  "the shafts are parallel or nearly so: beta_1 + beta_2 must be at least 5° in size; use gear.pair "
                  "for parallel shafts"},
      Rule<Input>{&drives, "beta_2, mu, alpha_n", "gear 1 cannot drive gear 2 against friction: reduce beta_2, or mu"},
      Rule<Input>{[](const Input& in) { return in.h_fP > in.h_aP; }, "h_fP, h_aP",
                  "the dedendum must exceed the addendum, for tip clearance"},
      Rule<Input>{[](const Input& in) {
                    return static_cast<int>(is_set(in.T_1)) + static_cast<int>(is_set(in.T_2)) +
                               static_cast<int>(is_set(in.P)) <=
                           1;
                  },
                  "T_1, T_2, P", "give the load once: as T_1, T_2 or P"},
      Rule<Input>{[](const Input& in) { return !is_set(in.P) || is_set(in.n_1); }, "P, n_1",
                  "a power needs the speed n_1"},
      Rule<Input>{[](const Input& in) { return !is_set(in.C_adm) || (carries(in) && is_set(in.n_1)); },
                  "C_adm, n_1, T_1, T_2, P",
                  "the allowable load value C_adm needs a load (T_1, T_2 or P) and the speed n_1"}};

  static constexpr bool turns = true;
  static Applies loaded(const Input& in) { return where(carries(in)); }
  static Applies locks(const Input& in) { return shown_by(in.locking == Locking::required); }
  static constexpr std::array modes{
      Mode<Input>{"wear", "wear and pitting of the tooth flanks", &loaded}.judged_by("u_C").asking(
          "give C_adm from the chart of a source at v_s, with n_1"),
      Mode<Input>{"contact", "contact ratio", &always<Input>}.judged_by("eps_n").of_shape(),
      Mode<Input>{"width", "face width", &always<Input>}.judged_by("x_b1, x_b2").of_shape(),
      Mode<Input>{"undercut", "undercut", &always<Input>}.judged_by("x_free").of_shape(),
      Mode<Input>{"pointed", "tip thickness", &always<Input>}.judged_by("s_a").of_shape(),
      Mode<Input>{"locking", "self-locking of the driven gear", &locks}.judged_by("x_L").special(),
      Mode<Input>{"rim_1", "rim thickness, gear 1", &unseen<Input>}.judged_by("m_R1").wanting("bore_1").special(),
      Mode<Input>{"rim_2", "rim thickness, gear 2", &unseen<Input>}.judged_by("m_R2").wanting("bore_2").special(),
      Mode<Input>{"root", "tooth breakage", &unseen<Input>}.special(),
      Mode<Input>{"scuffing", "scuffing", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special(),
      Mode<Input>{"backlash", "backlash", &unseen<Input>}.special(),
      Mode<Input>{"overload", "tooth overload at peak torque", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::gear
