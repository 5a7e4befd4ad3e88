// The course of one belt around any number of pulleys: driven ones, guide and tensioning rollers, inside or outside.
//
// Decides wraps, spans and the exact length of the belt, or how far a tensioner has to move for a belt that can be
// bought; with powers the tension of every span from the slack one behind the driving pulley on, the friction that each
// pulley needs, and the load of every shaft as a vector. The belt runs through the pulleys in the order of the list,
// and the first one drives. Lengths are those of the line that the diameters are given for. Not covered: crossed belts
// (belt.flat), shafts that are not parallel, losses, slip between the pulleys.
#pragma once

#include "calculators/belt/course_types.hpp"
#include "calculators/belt/loop.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::belt {

struct Course : CourseTypes {
  static constexpr auto id = "belt.course";
  static constexpr auto title = "Multi-pulley belt layout";
  static constexpr auto scope =
      "Wrap angles, spans and exact length of a belt around any number of inside and outside pulleys and "
      "idlers, or the tensioner position for a given length, with span tensions, friction and shaft loads at "
      "known powers; crossed belts, losses and slip are not covered.";
  static constexpr auto source = "[B40], [Shigley-17]";
  static constexpr auto headline = "L = {L}";
  static constexpr auto synonyms =
      "serpentine belt, multi-pulley drive, belt layout, belt length, idler, tensioner, wrap angle, span, "
      "Mehrscheibentrieb, Spannrolle, Umlenkrolle, Riemenlänge, belt, Riemen, многошкивная передача, "
      "натяжной ролик, длина ремня";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Fan and pump on one belt, with a tensioner"

[common_belt]
calculator = "belt.course"
n_1 = "1450 rpm"
mu = 0.5
q = "0.3 kg/m"
S_adm = "2 kN"
L = "2360 mm"
turns = "cw"
pulleys = [
  { name = "motor", x = "0 mm", y = "0 mm", d = "160 mm" },
  { name = "roller", x = "60 mm", y = "280 mm", d = "80 mm", side = "outside", along = "-30 deg" },
  { name = "pump", x = "300 mm", y = "480 mm", d = "200 mm", P = "3 kW" },
  { name = "fan", x = "600 mm", y = "100 mm", d = "250 mm", P = "4 kW" },
]
)";

  static constexpr Fields inputs{
      ListField{&Input::pulleys, "pulleys", "pulleys in running order of the belt; the first is the driver"},
      Choice{&Input::turns, "turns", "direction of rotation of the first pulley"}.may_be_missing(),
      Field{&Input::L, "L", mm, "belt length, if one pulley is adjustable"}.positive().may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the first pulley"}.positive().may_be_missing(),
      Field{&Input::mu, "mu", ratio,
            "coefficient of friction of pulleys without their own; groove of angle phi: mu / sin(phi/2)"}
          .within(0.01, 10)
          .usually(0.1, 2)
          .may_be_missing(),
      Field{&Input::q, "q", kg_per_m, "belt mass per length"}.at_least(0).usually(0.005, 20),
      Field{&Input::S_0, "S_0", N, "slack side tension, after the first pulley; omitted: the minimum"}
          .positive()
          .may_be_missing(),
      Field{&Input::S_adm, "S_adm", N, "allowable belt tension (safety factor included)"}.positive().may_be_missing()};

  static constexpr Fields results{
      Field{&Result::L, "L", mm, "belt length"},
      Field{&Result::s, "s", mm, "displacement of the adjustable pulley, positive in its direction"},
      Field{&Result::v, "v", m_per_s, "belt speed"},
      Field{&Result::f_B, "f_B", Hz, "flex rate of the belt"},
      Field{&Result::P_1, "P_1", kW, "power of the driving pulley"},
      Field{&Result::F_c, "F_c", N, "centrifugal tension"},
      Field{&Result::S_0_min, "S_0_min", N, "minimum slack side tension"},
      Field{&Result::S_0, "S_0", N, "slack side tension"},
      Field{&Result::S_max, "S_max", N, "maximum belt tension"},
      ListField{&Result::pulleys, "pulleys", "pulleys in running order of the belt"},
      Field{&Result::u_S, "u_S", ratio, "friction: required / actual slack side tension"}
          .check("mu")
          .where_it_applies(),
      Field{&Result::N_min, "N_min", N, "minimum tension acting on a pulley, without centrifugal tension"}
          .limit(1e-9, 1e9, "S_0, mu")
          .criterion()
          .where_it_applies(),
      Field{&Result::u_T, "u_T", ratio, "strength: maximum / allowable belt tension"}
          .check("S_adm")
          .where_it_applies()};

  static bool tensioner_fits(const Input& in);
  static FieldFault wrong_tensioner(const Input& in);
  static bool powers_fit(const Input& in);
  static FieldFault wrong_power(const Input& in);
  static bool backs_known(const Input& in);
  static FieldFault open_back(const Input& in);
  static bool closes(const Input& in);
  static FieldFault flaw_of(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return in.pulleys.size() > 1; }, "pulleys",
                  "a belt needs at least two pulleys"},
      Rule<Input>{[](const Input& in) { return in.pulleys.empty() || in.pulleys[0].side == Side::inside; }, "pulleys",
                  "the first (driving) pulley must be inside the belt"},
      Rule<Input>{&tensioner_fits, "L, pulleys", "a length L needs exactly one movable pulley, and vice versa",
                  &wrong_tensioner},
      Rule<Input>{&powers_fit, "pulleys, n_1, mu, S_0",
                  "powers need a speed and mu or S_0, and the first pulley drives", &wrong_power},
      Rule<Input>{&backs_known, "pulleys, mu", "a pulley on the back of the belt needs its own coefficient of friction",
                  &open_back},
      Rule<Input>{&closes, "pulleys, L", "the belt does not run through these pulleys", &flaw_of}};

  /// The lightest belts, with cords of aramid or carbon, carry 30 kN per kg/m.
  static double least_mass(const Input& in) {
    constexpr double most_strength = 40e3;  // N per kg/m
    return in_si(in.S_adm) / most_strength;
  }
  static constexpr std::array bounds{Bound<Input>{"q", "belts of this strength", &least_mass}.least()};
  static constexpr bool turns = true;
  static bool carries(const Input& in);
  static Applies loaded(const Input& in) { return where(carries(in)); }
  static bool runs_fast(const Input& in);
  static Applies beyond_speed(const Input& in);
  static Applies beyond_bending(const Input& in);
  static constexpr std::array modes{
      Mode<Input>{"centrifugal", "centrifugal tension above 10 m/s",
                  [](const Input& in) { return where(carries(in) && runs_fast(in) && !(in.q > 0.0 * kg_per_m.one)); }}
          .wanting("q"),
      Mode<Input>{"grip", "belt slip on pulleys", &loaded}.judged_by("u_S"),
      Mode<Input>{"lifting", "belt lift-off from pulleys", &loaded}.judged_by("N_min"),
      Mode<Input>{"strength", "tensile strength at maximum tension", &loaded}.judged_by("u_T"),
      Mode<Input>{"bending", "pulley diameter and flex rate", &beyond_bending}.special(),
      Mode<Input>{"speed", "belt and rim speed", &beyond_speed}.special(),
      Mode<Input>{"radial_load", "radial load on the motor shaft", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::belt
