// A V-belt drive of two pulleys on one stated basis: course, rated power, number of belts, tension and how to measure
// it, shaft loads, pulleys, room for adjustment.
//
// Decides how many belts of a section carry the power (or whether the given number does), by the rated power of one
// belt with the wrap, length and count factors of the same basis; the initial tension by the rule of that basis; and
// whether the grooves hold it by Euler's condition with the wedge factor of each pulley's own groove. Not covered:
// crossed belts, more than two pulleys, classes 0 to II, joined belts, raw-edge belts.
#pragma once

#include "calculators/belt/geometry.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "calculators/belt/v/data.hpp"
#include "calculators/belt/v/types.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <vector>

namespace loadpath::belt {

struct V : VTypes {
  static constexpr auto id = "belt.v";
  static constexpr auto title = "V-belt drive";
  static constexpr auto scope =
      "Number of belts, course, initial tension with its measurement, shaft loads and pulleys of an open V-belt drive "
      "with two pulleys, on one basis: ISO 5292 (GOST 1284.3, classes III and IV) or Optibelt. Within the diameters, "
      "speeds and lengths that the basis rates. A life is given only where the basis states one. What shafts take "
      "whole is the largest pull: in running, at standstill or of new belts.";
  static constexpr auto source = "[B40], [GOST1284.3], [Optibelt-V]";
  static constexpr auto headline = "{z} belts {section}|{z} belts";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Compressor with wedge belts"

[compressor]
calculator = "belt.v"
basis = "optibelt"
section = "SPB"
P = "30 kW"
duty = "medium"
motor = "normal"
h_day = "16 h"
n_1 = "1460 rpm"
d_1 = "200 mm"
d_2 = "400 mm"
L = "2650 mm"
)";

  static constexpr Fields inputs{
      RecordField<Input>{"drive", "a drive that belt.v_sizing has picked, whole: drive = \"=pick.best\""},
      Choice{&Input::basis, "basis", "system of ratings and factors; must be stated"},
      NameField{&Input::section, "section", "section of the belt: A, SPB"},
      Choice{&Input::belt_class, "belt_class", "class of the belt; goes with the basis iso"}.may_be_missing(),
      Field{&Input::P, "P", kW, "power, the mean over the cycle"}
          .load()
          .at_least_that_of_source("shafts[#].P")
          .positive()
          .usually(0.05, 3000),
      Field{&Input::K_A, "K_A", ratio, "service factor of the basis (C_P, c_2): what the power does not contain, once"}
          .at_least(1)
          .usually(1, 2)
          .may_be_missing()
          .factor(),
      Field{&Input::K_A_1, "K_A_1", ratio, "service factor for one shift, for the initial tension on the basis iso"}
          .positive()
          .usually(1, 2)
          .may_be_missing(),
      Choice{&Input::duty, "duty", "kind of load"}.may_be_missing(),
      Choice{&Input::motor, "motor", "torque of the motor"}.may_be_missing(),
      Field{&Input::h_day, "h_day", hour, "use per day"}.positive().within(0.01, 24).may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the driving pulley"}
          .positive()
          .at_least_that_of_source("shafts[#].n")
          .usually(20, 9000),
      Field{&Input::epsilon, "epsilon", ratio, "slip"}.within(0, 0.1).usually(0, 0.03),
      Field{&Input::d_1, "d_1", mm, "datum diameter of the driving pulley"}
          .positive()
          .same_as_that_of_source("stages[#].d_1")
          .usually(20, 3000),
      Field{&Input::d_2, "d_2", mm, "datum diameter of the driven pulley"}
          .positive()
          .same_as_that_of_source("stages[#].d_2")
          .usually(20, 3000),
      Field{&Input::a, "a", mm, "centre distance"}.positive().usually(20, 2e4).may_be_missing(),
      Field{&Input::L, "L", mm, "datum length of the belt, in place of a"}
          .positive()
          .usually(200, 2e4)
          .may_be_missing(),
      Count{&Input::z, "z", 0, 100, "number of belts; 0: as many as the power asks for"}.may_be_missing(),
      Choice{&Input::C_K_end, "C_K_end", "end of the range of the count factor, basis iso"}.may_be_missing(),
      Choice{&Input::tensioning, "tensioning", "what keeps the tension"}.may_be_missing(),
      Field{&Input::mu, "mu", ratio, "coefficient of friction, for the grip of the grooves"}
          .within(0.01, 1.5)
          .usually(0.1, 0.6)
          .may_be_missing(),
      Field{&Input::v_rim_adm, "v_rim_adm", m_per_s, "largest speed of the rim; cast iron 35 m/s"}.positive().usually(
          10, 100)};

  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "transmission ratio n_1/n_2 with slip"},
      Field{&Result::n_2, "n_2", rpm, "speed of the driven pulley"},
      Field{&Result::n_k, "n_k", rpm, "speed of the smaller pulley, without slip"},
      Field{&Result::v, "v", m_per_s, "speed of the belt"},
      Field{&Result::a, "a", mm, "centre distance; usual are 0.7 to 2 times the sum of the diameters"},
      Field{&Result::L, "L", mm, "datum length of the belt"},
      Field{&Result::l_s, "l_s", mm, "span between the points of contact"},
      Field{&Result::gamma, "gamma", deg, "inclination of the spans to the line of centres"},
      Field{&Result::alpha_1, "alpha_1", deg, "wrap of the driving pulley"},
      Field{&Result::alpha_2, "alpha_2", deg, "wrap of the driven pulley"},
      Field{&Result::alpha, "alpha", deg, "wrap of the smaller pulley"},
      Field{&Result::K_A, "K_A", ratio, "service factor"},
      Field{&Result::P_B, "P_B", kW, "design power"}.holding("K_A"),
      Field{&Result::P_0, "P_0", kW, "rated power of one belt, equal pulleys"},
      Field{&Result::dP, "dP", kW, "increment by the ratio"},
      Field{&Result::c_alpha, "c_alpha", ratio, "wrap factor (C_alpha, c_1)"},
      Field{&Result::c_L, "c_L", ratio, "length factor (C_L, c_3)"},
      Field{&Result::z_0, "z_0", ratio, "number of belts before the count factor"},
      Count{&Result::z, "z", 0, 100, "number of belts"},
      Field{&Result::C_K, "C_K", ratio, "count factor"},
      Field{&Result::P_all, "P_all", kW, "power that the belts can carry"},
      Field{&Result::F_c, "F_c", N, "centrifugal part of the tension of one belt"},
      Field{&Result::F_0, "F_0", N, "initial tension of a span of one belt, run in"},
      Field{&Result::F_0_new, "F_0_new", N, "initial tension of a new belt"},
      Field{&Result::S_1, "S_1", N, "tension of the tight span of one belt"},
      Field{&Result::S_2, "S_2", N, "tension of the slack span of one belt"},
      Field{&Result::y, "y", mm, "deflection of a span that the test force is for"},
      Field{&Result::Q, "Q", N, "test force in the middle of a span, run in"},
      Field{&Result::Q_new, "Q_new", N, "test force, new belt"},
      Field{&Result::f_s, "f_s", Hz, "frequency of the plucked span, run in"},
      Field{&Result::f_s_new, "f_s_new", Hz, "frequency of the plucked span, new belt"},
      pull(&Result::R_0, "R_0", "shaft load at standstill, along the line of centres"),
      pull(&Result::R_new, "R_new", "shaft load at standstill, new belts"),
      pull(&Result::R_x, "R_x", "shaft load in running, toward the other pulley", "R_y, shaft_1.T|shaft_2.T"),
      pull(&Result::R_y, "R_y", "shaft load in running, to the side of the tight span", "R_x, shaft_1.T|shaft_2.T"),
      pull(&Result::R, "R", "shaft load in running"),
      Field{&Result::theta_R, "theta_R", deg, "its direction against the line of centres"},
      Group{&Result::shaft_1, "shaft_1", "most that the belts do to the driving shaft, new or run in: load"}
          .handed_over(),
      Group{&Result::shaft_2, "shaft_2", "most that the belts do to the driven shaft, new or run in: load"}
          .handed_over(),
      Field{&Result::B, "B", mm, "width of the pulleys"},
      Field{&Result::d_a1, "d_a1", mm, "outer diameter of the driving pulley"},
      Field{&Result::d_a2, "d_a2", mm, "outer diameter of the driven pulley"},
      Field{&Result::phi_1, "phi_1", deg, "groove angle of the driving pulley"},
      Field{&Result::phi_2, "phi_2", deg, "groove angle of the driven pulley"},
      Field{&Result::v_rim, "v_rim", m_per_s, "larger speed of the two rims"},
      Field{&Result::Delta_1, "Delta_1", mm, "least increase of the centre distance, for tensioning"},
      Field{&Result::Delta_2, "Delta_2", mm, "least decrease of the centre distance, for fitting"},
      Field{&Result::f_B, "f_B", Hz, "bendings of the belt per second"},
      Field{&Result::L_h, "L_h", hour, "mean life that the basis states"},
      Field{&Result::u_P, "u_P", ratio, "power: design power over what the belts can carry"}.check(),
      Field{&Result::u_grip, "u_grip", ratio, "grip: tension that friction in the grooves needs over what there is"}
          .check("mu"),
      Field{&Result::u_rim, "u_rim", ratio, "rim: larger speed of the rims over the allowable one"}.check(),
      Field{&Result::u_B, "u_B", ratio, "bending frequency over the largest one"}.check(),
      Field{&Result::P_N, "P_N", kW, "rated power of one belt; there must be some"}.limit(1e-3, 1e4),
      Field{&Result::x_d, "x_d", ratio, "smaller pulley, from the smallest (0) to the largest (1) rated one"}.limit(0,
                                                                                                                    1),
      Field{&Result::x_n, "x_n", ratio, "its speed, from the lowest (0) to the highest (1) rated one"}.limit(0, 1),
      Field{&Result::x_L, "x_L", ratio, "length, from the shortest (0) to the longest (1) listed belt"}.limit(0, 1),
      Field{&Result::x_alpha, "x_alpha", ratio, "wrap of the smaller pulley over the least one"}.limit(1, 10),
      Field{&Result::x_v, "x_v", ratio, "speed over the largest one of the section"}.limit(0, 1),
      Field{&Result::x_z, "x_z", ratio, "number of belts over the most that share a load, 16"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::off_d, "off_d", ratio, "pulleys whose diameter no list has: sizes of series v_pulleys"}.limit(0,
                                                                                                                   0.5),
      Field{&Result::off_L, "off_L", ratio, "1 where no list has a belt of this length"}
          .limit(0, 0.5)
          .where_it_applies(),
      Field{&Result::g_r, "g_r", mm, "room between the rims of the pulleys"}.limit(0, 1e5).criterion(),
      Field{&Result::g_f, "g_f", mm, "room between the rims when the belts are fitted"}.limit(0, 1e5).criterion()};

  static bool section_is_known(const Input& in);
  static FieldFault unknown_section(const Input& in);
  static bool class_fits(const Input& in);
  static FieldFault wrong_class(const Input& in);
  static bool service_is_given(const Input& in);
  static bool clear_of_each_other(const Input& in);
  static FieldFault touching(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.basis != Basis::unstated; }, "basis",
                  "state the basis, iso or optibelt: ratings and factors of one do not go with the other"},
      Rule<Input>{&section_is_known, "section, basis", "the basis does not rate this section", &unknown_section},
      Rule<Input>{&class_fits, "belt_class, basis", "the class of the belt goes with the basis iso", &wrong_class},
      Rule<Input>{&service_is_given, "K_A, duty, motor, h_day",
                  "give K_A; on the basis optibelt duty, motor and h_day may stand in its place, never both"},
      Rule<Input>{[](const Input& in) { return !is_set(in.K_A_1) || in.basis == Basis::iso; }, "K_A_1, basis",
                  "K_A_1 belongs to the basis iso; the tension of the basis optibelt takes the one K_A"},
      Rule<Input>{[](const Input& in) { return in.C_K_end == End::low || in.basis == Basis::iso; }, "C_K_end, basis",
                  "the count factor belongs to the basis iso; the basis optibelt has none"},
      Rule<Input>{[](const Input& in) { return is_set(in.a) != is_set(in.L); }, "a, L",
                  "give either the centre distance a or the length of the belt L"},
      Rule<Input>{&clear_of_each_other, "a, L", "the pulleys must stand clear of each other", &touching}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"P", "mean"}};

  static constexpr std::array modes{
      Mode<Input>{"power", "power of the belts", &always<Input>}.judged_by("u_P, P_N, x_n"),
      Mode<Input>{"pulley", "least pulley of the section", &always<Input>}.judged_by("x_d"),
      Mode<Input>{"length", "length that the basis rates", &always<Input>}.judged_by("x_L").of_shape(),
      Mode<Input>{"wrap", "wrap of the smaller pulley", &always<Input>}.judged_by("x_alpha"),
      Mode<Input>{"grip", "slip in the grooves, by Euler's condition",
                  [](const Input& in) { return shown_by(is_set(in.mu)); }}
          .judged_by("u_grip"),
      Mode<Input>{"speed", "speed of the section", &always<Input>}.judged_by("x_v"),
      Mode<Input>{"rim", "bursting of the rims", &always<Input>}.judged_by("u_rim"),
      Mode<Input>{"bending", "bending frequency", &always<Input>}.judged_by("u_B"),
      Mode<Input>{"sharing", "load shared by many belts", &always<Input>}.judged_by("x_z"),
      Mode<Input>{"room", "room between the rims", &always<Input>}.judged_by("g_r").of_shape(),
      Mode<Input>{"fitting", "room to fit the belts", &always<Input>}.judged_by("g_f").of_shape(),
      Mode<Input>{"sold_pulleys", "pulleys that are sold", &always<Input>}.judged_by("off_d").of_shape(),
      Mode<Input>{"sold_belts", "belts of a length that is sold",
                  [](const Input& in) { return shown_by(is_set(in.L)); }}
          .judged_by("off_L")
          .wanting("L")
          .of_shape(),
      Mode<Input>{"radial_load", "radial load that the motor bears", &unseen<Input>}.special(),
      Mode<Input>{"heat", "heat, oil and dust", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<draw::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::belt
