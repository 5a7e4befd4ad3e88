// A V-belt drive of two pulleys on one stated basis: course, rated power, number of belts, tension and how to measure
// it, shaft loads, pulleys, room for adjustment.
//
// Decides how many belts of a section carry the power (or whether the given number does), by the rated power of one
// belt with the wrap, length and count factors of the same basis; the initial tension by the rule of that basis; and
// whether the grooves hold it by Euler's condition with the wedge factor of each pulley's own groove. Not covered:
// crossed belts, more than two pulleys, classes 0 to II, joined belts, raw-edge belts. The linked shaft load is the
// largest resultant: in operation, at standstill or with new belts.
#pragma once

#include "calculators/belt/driven.hpp"
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
      "Number of belts, length, initial tension and its measurement, shaft loads and pulleys of a two-pulley "
      "open V-belt drive, rated by ISO 5292 (GOST 1284.3, classes III and IV) or Optibelt, within the rated "
      "diameters, speeds and lengths; life is given only where the rating states one.";
  static constexpr auto source = "[B40], [GOST1284.3], [Optibelt-V]";
  static constexpr auto headline = "{section}, z = {z}|V-belt, z = {z}";
  static constexpr auto details =
      "d_1 = {d_1}, d_2 = {d_2}, L = {L}, a = {a}, initial tension F_0 = {F_0} per belt, shaft load R = {R}";
  static constexpr auto synonyms =
      "V-belt, wedge belt, narrow V-belt, SPZ, SPA, SPB, belt drive, power rating, ISO 5292, GOST 1284.3, Optibelt, "
      "Keilriemen, Schmalkeilriemen, Riementrieb, belt, клиноремённая передача, клиновой ремень";
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

  static constexpr auto inputs = join(
      Fields{RecordField<Input>{"drive", "drive selected by belt.v_sizing: drive = \"=pick.best\""},
             Choice{&Input::basis, "basis", "rating method: ISO 5292 or Optibelt"}.may_be_missing(),
             NameField{&Input::section, "section", "belt section, e.g. A, SPB"}.findable("v_belt"),
             Choice{&Input::belt_class, "belt_class", "belt class, with the basis iso"}.may_be_missing(),
             Field{&Input::P, "P", kW, "power, mean over the cycle"}
                 .load()
                 .at_least_that_of_source("shafts[#].P")
                 .positive()
                 .usually(0.05, 3000),
             Field{&Input::K_A, "K_A", ratio, "service factor of the basis (C_P, c_2; 1 if the power includes it)"}
                 .at_least(1)
                 .usually(1, 2)
                 .may_be_missing()
                 .factor(),
             Field{&Input::K_A_1, "K_A_1", ratio, "service factor for one shift, for the initial tension (basis iso)"}
                 .positive()
                 .usually(1, 2)
                 .may_be_missing(),
             Choice{&Input::duty, "duty", "load type"}.may_be_missing(),
             Choice{&Input::motor, "motor", "starting torque of the driver: normal or high"}.may_be_missing(),
             Field{&Input::h_day, "h_day", hour, "daily operating time"}.positive().within(0.01, 24).may_be_missing(),
             Field{&Input::n_1, "n_1", rpm, "speed of the driving pulley"}
                 .positive()
                 .near_that_of_source("shafts[#].n")
                 .usually(20, 9000),
             Field{&Input::epsilon, "epsilon", ratio, "slip"}.within(0, 0.1).usually(0, 0.03),
             Field{&Input::d_1, "d_1", mm, "datum diameter of the driving pulley"}
                 .positive()
                 .at_least_that_of_source("d")
                 .same_as_that_of_source("stages[#].d_1, drive.d_1")
                 .usually(20, 3000),
             Field{&Input::d_2, "d_2", mm, "datum diameter of the driven pulley"}
                 .positive()
                 .same_as_that_of_source("stages[#].d_2, drive.d_2")
                 .usually(20, 3000)
                 .may_be_missing()},
      driven_inputs<Input>(),
      Fields{
          Field{&Input::a, "a", mm, "centre distance"}.positive().usually(20, 2e4).may_be_missing(),
          Field{&Input::L, "L", mm, "datum length of the belt, replaces a"}
              .positive()
              .usually(200, 2e4)
              .may_be_missing(),
          Count{&Input::z, "z", 0, 100, "number of belts; 0: as required by the power"}.may_be_missing(),
          Choice{&Input::C_K_end, "C_K_end", "low or high end of the belt-number factor, basis iso"}.may_be_missing(),
          Choice{&Input::tensioning, "tensioning", "tensioning method"}.may_be_missing(),
          Field{&Input::mu, "mu", ratio, "coefficient of friction, for traction in the grooves"}
              .within(0.01, 1.5)
              .usually(0.1, 0.6)
              .may_be_missing(),
          Field{&Input::v_rim_adm, "v_rim_adm", m_per_s, "maximum rim speed; cast iron 35 m/s"}
              .positive()
              .usually(10, 100)
              .customarily_at_most(60)});

  static constexpr auto results = join(
      Fields{Choice{&Result::rating, "rating", "governing rating method"}},
      driven_results<Result>("datum diameter of the driven pulley found"),
      Fields{
          Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 with slip"},
          Field{&Result::n_2, "n_2", rpm, "speed of the driven pulley"},
          Field{&Result::n_k, "n_k", rpm, "speed of the smaller pulley, without slip"},
          Field{&Result::v, "v", m_per_s, "belt speed"},
          Field{&Result::a, "a", mm, "centre distance; 0.7 to 2 times the sum of the diameters is usual"},
          Field{&Result::L, "L", mm, "datum length of the belt"},
          Field{&Result::l_s, "l_s", mm, "free span length"},
          Field{&Result::gamma, "gamma", deg, "span angle to the line of centres"},
          Field{&Result::alpha_1, "alpha_1", deg, "wrap angle, driving pulley"},
          Field{&Result::alpha_2, "alpha_2", deg, "wrap angle, driven pulley"},
          Field{&Result::alpha, "alpha", deg, "wrap angle, smaller pulley"},
          Field{&Result::K_A, "K_A", ratio, "service factor"},
          Field{&Result::P_B, "P_B", kW, "design power"}.holding("K_A"),
          Field{&Result::P_0, "P_0", kW, "rated power of one belt, equal pulleys"},
          Field{&Result::dP, "dP", kW, "power increment for the speed ratio"},
          Field{&Result::c_alpha, "c_alpha", ratio, "arc-of-contact factor (C_alpha, c_1)"},
          Field{&Result::c_L, "c_L", ratio, "length factor (C_L, c_3)"},
          Field{&Result::z_0, "z_0", ratio, "number of belts before the belt-number factor"},
          Count{&Result::z, "z", 0, 100, "number of belts"},
          Field{&Result::C_K, "C_K", ratio, "belt-number factor"},
          Field{&Result::P_all, "P_all", kW, "power rating of the belts"},
          Field{&Result::F_c, "F_c", N, "centrifugal tension of one belt"},
          Field{&Result::F_0, "F_0", N, "initial tension of one belt span, run-in"},
          Field{&Result::F_0_new, "F_0_new", N, "initial tension of a new belt"},
          Field{&Result::S_1, "S_1", N, "tight side tension of one belt"},
          Field{&Result::S_2, "S_2", N, "slack side tension of one belt"},
          Field{&Result::y, "y", mm, "deflection of a span under the test force"},
          Field{&Result::Q, "Q", N, "test force at mid-span, run-in belt"},
          Field{&Result::Q_new, "Q_new", N, "test force, new belt"},
          Field{&Result::f_s, "f_s", Hz, "natural frequency of the span, run-in belt"},
          Field{&Result::f_s_new, "f_s_new", Hz, "natural frequency of the span, new belt"},
          pull(&Result::R_0, "R_0", "shaft load at standstill, along the line of centres"),
          pull(&Result::R_new, "R_new", "shaft load at standstill, new belts"),
          pull(&Result::R_x, "R_x", "shaft load in operation, toward the other pulley", "R_y, shaft_1.T|shaft_2.T"),
          pull(&Result::R_y, "R_y", "shaft load in operation, to the side of the tight span",
               "R_x, shaft_1.T|shaft_2.T"),
          pull(&Result::R, "R", "shaft load in operation"),
          Field{&Result::theta_R, "theta_R", deg, "direction of the shaft load to the line of centres"},
          Group{&Result::shaft_1, "shaft_1", "maximum shaft load on the driving shaft, new or run-in belts, for load"}
              .handed_over(),
          Group{&Result::shaft_2, "shaft_2", "maximum shaft load on the driven shaft, new or run-in belts, for load"}
              .handed_over(),
          Field{&Result::B, "B", mm, "pulley face width"},
          Field{&Result::d_a1, "d_a1", mm, "outer diameter of the driving pulley"},
          Field{&Result::d_a2, "d_a2", mm, "outer diameter of the driven pulley"},
          Field{&Result::phi_1, "phi_1", deg, "groove angle of the driving pulley"},
          Field{&Result::phi_2, "phi_2", deg, "groove angle of the driven pulley"},
          Field{&Result::v_rim, "v_rim", m_per_s, "larger rim speed of the two pulleys"},
          Field{&Result::Delta_1, "Delta_1", mm, "minimum increase of the centre distance for tensioning"},
          Field{&Result::Delta_2, "Delta_2", mm, "minimum decrease of the centre distance for installation"},
          Field{&Result::f_B, "f_B", Hz, "flex rate of the belt"},
          Field{&Result::L_h, "L_h", hour, "mean life stated by the basis"},
          Field{&Result::u_P, "u_P", ratio, "power: design power / power rating of the belts"}.check(),
          Field{&Result::u_grip, "u_grip", ratio, "traction: required / actual belt tension"}.check("mu"),
          Field{&Result::u_rim, "u_rim", ratio, "rim: larger rim speed / allowable rim speed"}.check(),
          Field{&Result::u_B, "u_B", ratio, "flex rate / maximum flex rate"}.check(),
          Field{&Result::P_N, "P_N", kW, "rated power of one belt (positive)"}.limit(1e-3, 1e4),
          Field{&Result::x_dmin, "x_dmin", ratio, "minimum pulley diameter of the section / smaller pulley"}
              .limit(0, 1 + 1e-9)
              .criterion(),
          Field{&Result::x_d, "x_d", ratio,
                "position of the smaller pulley in the rated range of diameters: 0 at its minimum, 1 at its maximum"}
              .limit(0, 1),
          Field{&Result::x_n, "x_n", ratio,
                "position of the speed of the smaller pulley in the rated range: 0 at its minimum, 1 at its maximum"}
              .limit(0, 1),
          Field{&Result::x_L, "x_L", ratio,
                "position of the belt length in the listed range: 0 at its minimum, 1 at its maximum"}
              .limit(0, 1),
          Field{&Result::x_alpha, "x_alpha", ratio, "wrap angle of the smaller pulley / minimum wrap angle"}.limit(1,
                                                                                                                   10),
          Field{&Result::x_v, "x_v", ratio, "belt speed / maximum speed of the section"}.limit(0, 1),
          Field{&Result::x_z, "x_z", ratio, "number of belts / maximum number that share a load, 16"}
              .limit(0, 1)
              .where_it_applies(),
          Field{&Result::off_d, "off_d", ratio, "number of non-standard pulley diameters (series v_pulleys)"}.limit(
              0, 0.5),
          Field{&Result::off_L, "off_L", ratio, "1 for a non-standard belt length"}.limit(0, 0.5).where_it_applies(),
          Field{&Result::g_r, "g_r", mm, "clearance between the pulley rims"}.limit(0, 1e5).criterion(),
          Field{&Result::g_f, "g_f", mm, "clearance between the pulley rims during installation"}
              .limit(0, 1e5)
              .criterion()});

  static bool section_is_known(const Input& in);
  static FieldFault unknown_section(const Input& in);
  static bool class_fits(const Input& in);
  static FieldFault wrong_class(const Input& in);
  static bool service_is_given(const Input& in);
  static bool clear_of_each_other(const Input& in);
  static FieldFault touching(const Input& in);
  static constexpr auto rules = join(
      driven_rules<Input>(),
      std::array{
          Rule<Input>{[](const Input& in) { return in.basis != Basis::unstated; }, "basis",
                      "give the basis, iso or optibelt: their ratings and factors must not be mixed"},
          Rule<Input>{&section_is_known, "section, basis", "the basis does not rate this section", &unknown_section},
          Rule<Input>{&class_fits, "belt_class, basis", "the belt class requires the basis iso", &wrong_class},
          Rule<Input>{&service_is_given, "K_A, duty, motor, h_day",
                      "give either K_A or, with the basis optibelt, duty = \"medium\", motor = \"normal\" and h_day = "
                      "\"16 h\""},
          Rule<Input>{[](const Input& in) { return !is_set(in.K_A_1) || in.basis == Basis::iso; }, "K_A_1, basis",
                      "K_A_1 requires the basis iso; the basis optibelt uses K_A for the tension"},
          Rule<Input>{[](const Input& in) { return in.C_K_end == End::low || in.basis == Basis::iso; },
                      "C_K_end, basis", "the belt-number factor requires the basis iso"},
          Rule<Input>{[](const Input& in) { return is_set(in.a) != is_set(in.L); }, "a, L",
                      "give either the centre distance a or the belt length L"},
          Rule<Input>{&clear_of_each_other, "a, L, d_1, d_2", "the pulleys must not overlap", &touching}});

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"P", "mean"}};

  static constexpr std::array modes{
      Mode<Input>{"power", "power rating of the belts", &always<Input>}.judged_by("u_P, P_N, x_n"),
      Mode<Input>{"pulley", "pulley diameter range", &always<Input>}.judged_by("x_dmin, x_d"),
      Mode<Input>{"length", "belt length range", &always<Input>}.judged_by("x_L").of_shape(),
      Mode<Input>{"wrap", "wrap angle, smaller pulley", &always<Input>}.judged_by("x_alpha"),
      Mode<Input>{"grip", "belt slip (Euler-Eytelwein)", [](const Input& in) { return shown_by(is_set(in.mu)); }}
          .judged_by("u_grip"),
      Mode<Input>{"speed", "maximum belt speed", &always<Input>}.judged_by("x_v"),
      Mode<Input>{"rim", "bursting of pulley rims", &always<Input>}.judged_by("u_rim"),
      Mode<Input>{"bending", "flex rate", &always<Input>}.judged_by("u_B"),
      Mode<Input>{"sharing", "load sharing between belts", &always<Input>}.judged_by("x_z"),
      Mode<Input>{"room", "clearance between pulley rims", &always<Input>}.judged_by("g_r").of_shape(),
      Mode<Input>{"fitting", "clearance for belt installation", &always<Input>}.judged_by("g_f").of_shape(),
      Mode<Input>{"sold_pulleys", "standard pulley diameters", &always<Input>}.judged_by("off_d").of_shape(),
      Mode<Input>{"sold_belts", "standard belt length", [](const Input& in) { return shown_by(is_set(in.L)); }}
          .judged_by("off_L")
          .wanting("L")
          .of_shape(),
      Mode<Input>{"radial_load", "radial load on the motor shaft", &unseen<Input>}.special(),
      Mode<Input>{"heat", "heat, oil and dust", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::belt
