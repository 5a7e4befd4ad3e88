// Set screws that hold a hub on its shaft: torque and force along the shaft against what the points hold.
//
// Decides by the holding power of a screw with a cup point, which holds along and around the shaft alike, at its
// surface: tests of manufacturers, [SPS], at the seating torque of the table; other points hold 1.07 (cone),
// 0.92 (flat, dog) and 0.90 (oval) of it, [SPS]. Two screws hold phi times two, typed: with an angle between them they
// hold less than twice one. These are mean values of tests: a safety of 1.5 to 2 for loads at rest and 4 to 8 for
// others, [SPS]. K_A acts once. Screws up to half as thick as the shaft: the point of a larger one does not bear on the
// round. Not covered: screws that loosen by vibration, a screw in tension.
#pragma once

#include "calculators/load/connection.hpp"
#include "calculators/shaft/parts/torque.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::shaft {

struct SetScrew {
  static constexpr auto id = "shaft.set_screw";
  static constexpr auto title = "Set screw connection";
  static constexpr auto scope =
      "Torque and axial force that one or two set screws transmit by their points, against the safety factors "
      "recommended by manufacturers from tests; self-loosening due to vibration and the indentation of the shaft "
      "are not covered.";
  static constexpr auto source = "[SPS]";
  static constexpr auto headline = "{i} x d = {d_s}";
  static constexpr auto subject = "holding of the screws";
  static constexpr auto synonyms =
      "set screw, grub screw, cup point, hub fastening, holding power, axial holding force, Gewindestift, "
      "Stellschraube, Madenschraube, установочный винт, стопорный винт";
  static constexpr auto example = R"([project]
title = "Pulley of a small fan"

[pulley]
calculator = "shaft.set_screw"
T = "8 N*m"
load_case = "static"
set_screw = "3/8"
d = "20 mm"
S = 2
)";

  enum class Case { unsaid, at_rest, dynamic };
  enum class Point { cup, cone, flat, dog, oval };

  struct Input {
    Length d_f = unset<Length>, h_t = unset<Length>, b_r = unset<Length>, bore = unset<Length>;
    Moment T = unset<Moment>;
    Force F_a = 0.0 * N;
    double K_A = 1.0;
    Case load_case = Case::unsaid;
    Length d = unset<Length>, d_bore = 0.0 * mm, d_s = unset<Length>;
    Stress R_e_1 = unset<Stress>;
    double S_F = unset<double>;
    Force F_h = unset<Force>;
    Point point = Point::cup;
    Whole i = 1;
    double phi = unset<double>;
    double k_H = 1.0;
    double S = unset<double>;
  };
  static Applies loaded(const Input& in);
  static Applies twisted(const Input& in);
  static Applies is_hard(const Input& in) { return where(in.R_e_1 > 1000.0 * MPa && in.k_H > 0.85); }
  static constexpr auto inputs = join(
      hub_inputs<Input>(),
      Fields{
          RecordField<Input>{"load", "shaft load of the mounted belt, chain or drive: load = \"=belts.shaft_2\""},
          Field{&Input::T, "T", N_m, "torque, magnitude"}.load().one_of_body("torque"),
          Field{&Input::F_a, "F_a", N, "axial force, magnitude"}.load(),
          Field{&Input::K_A, "K_A", ratio, "application factor K_A on torque and axial force (1 if they include it)"}
              .at_least(1)
              .usually(1, 4)
              .factor(),
          Choice{&Input::load_case, "load_case", "load case: static or dynamic"}.may_be_missing(),
          Field{&Input::d, "d", mm, "shaft diameter"}.at_most_that_of_source("d, d_max").positive().usually(1.5, 120),
          Field{&Input::d_bore, "d_bore", mm, "bore diameter of the shaft"}.at_least(0).one_of_body("bore"),
          Field{&Input::d_s, "d_s", mm, "nominal diameter of a set screw"}
              .positive()
              .from("set_screw", "d_s")
              .where_it_has(),
          Field{&Input::R_e_1, "R_e_1", MPa, "yield strength of the shaft, for torsion"}
              .positive()
              .at_most_that_of_source("R_e")
              .usually(150, 2000)
              .customarily_at_most(most_yield_strength)
              .may_be_missing(),
          shaft_safety<Input>(),
          Field{&Input::F_h, "F_h", N, "holding force of one cup point screw at the shaft surface"}.positive().from(
              "set_screw", "F_h"),
          Choice{&Input::point, "point", "point type of the screw"},
          Count{&Input::i, "i", 1, 2, "number of screws"}.may_be_missing(),
          Field{&Input::phi, "phi", ratio,
                "holding force of two screws / twice that of one, by the angle between them, from tests"}
              .within(0.5, 1)
              .customarily_at_most(0.9)
              .may_be_missing()
              .factor(),
          Field{&Input::k_H, "k_H", ratio,
                "hardness factor: 0.85 if the shaft is not at least 10 HRC softer than the screw"}
              .within(0.5, 1)
              .factor(),
          Field{&Input::S, "S", ratio, "required safety factor: 1.5 to 2 for static loads, 4 to 8 for dynamic loads"}
              .at_least(1)
              .usually(1.5, 8)
              .customarily_at_least(1.5)
              .factor()});

  struct Result {
    Force F_t = unset<Force>, F = unset<Force>, F_zul = unset<Force>;
    Moment T_h = unset<Moment>;
    Stress tau_t = unset<Stress>;
    double u = unset<double>, u_S = unset<double>, u_t = unset<double>, x_d = unset<double>, x_h = unset<double>;
    double m_R = unset<double>, x_R = unset<double>;
    Connection connection;
  };
  static constexpr Fields results{
      Field{&Result::F_t, "F_t", N, "circumferential force at the shaft surface"}.holding("K_A"),
      Field{&Result::F, "F", N, "resultant of circumferential and axial force"}.holding("K_A"),
      Field{&Result::F_zul, "F_zul", N, "holding force of the screws"},
      Field{&Result::T_h, "T_h", N_m, "holding torque without axial force"},
      Field{&Result::u, "u", ratio, "slip: S x resultant force / holding force"}.check(),
      Field{&Result::u_S, "u_S", ratio, "minimum safety factor of the load case / required safety factor"}.check(),
      Field{&Result::tau_t, "tau_t", MPa, "torsional stress of the shaft"}.holding("K_A"),
      Field{&Result::u_t, "u_t", ratio, "torsion of the shaft: S_F x equivalent stress / yield strength"}.check(
          "S_F, R_e_1"),
      Field{&Result::x_d, "x_d", ratio, "screw diameter / shaft diameter (limit set by loadpath)"}
          .limit(0, 0.5 * (1 + 1e-9))
          .where_it_applies(),
      Field{&Result::x_h, "x_h", ratio,
            "holding force / screw cross section / 150 MPa; screws of [SPS] have 60 to 140 MPa (limit set by loadpath)"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      rim_of_gear<Result>(),
      wall_of_hub<Result>(
          "screw diameter / wall of the hub under the root circle, for the thread length (limit set by loadpath)"),
      Group{&Result::connection, "connection", connection_doc}.handed_over()};

  static constexpr std::array rules{
      safety_has_strength<Input>(),
      Rule<Input>{[](const Input& in) { return !is_set(in.d_f) || in.d < in.d_f; }, "d_f, d",
                  "the shaft diameter must not exceed the root diameter of the mounted component"},
      Rule<Input>{[](const Input& in) { return bore_fits(in.bore, in.d); }, "bore, d",
                  "the bore of the mounted component must equal the shaft diameter; for another component give its "
                  "bore, with because.bore = \"...\""},
      Rule<Input>{[](const Input& in) { return !(in.d_bore >= in.d); }, "d_bore, d",
                  "the bore must be smaller than the shaft core"},
      Rule<Input>{[](const Input& in) { return (in.i > 1) == is_set(in.phi); }, "i, phi",
                  "two screws transmit less than twice one: give phi if i = 2, only then"}};

  static constexpr std::array modes{
      Mode<Input>{"slip", "circumferential and axial slip", &loaded}.judged_by("u, x_d, x_h"),
      Mode<Input>{"screw", "holding force, screw size unknown", [](const Input& in) { return where(!is_set(in.d_s)); }}
          .wanting("d_s"),
      Mode<Input>{"wall", "thread length in the hub wall", &has_root<Input>}
          .judged_by("m_R, x_R")
          .wanting("d_f")
          .of_shape(),
      Mode<Input>{"safety", "minimum safety factor for the load case", &loaded}.judged_by("u_S"),
      Mode<Input>{"bore", "wall of a hollow shaft under the point",
                  [](const Input& in) { return where(in.d_bore > 0.0 * mm); }},
      Mode<Input>{"hardness", "shaft softer than the screw", &is_hard}.advising(
          "a shaft of more than 1000 MPa has some 35 HRC, and a screw 45: give k_H = 0.85"),
      Mode<Input>{"core", "torsional yielding of the shaft", &twisted}.judged_by("u_t"),
      Mode<Input>{"seat", "hub tilting", &unseen<Input>}.by_companions(),
      Mode<Input>{"loosening", "self-loosening due to vibration", &unseen<Input>}.special(),
      Mode<Input>{"shaft", "shaft fatigue at the point indentation", &unseen<Input>}.in_service()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(SetScrew::Case) {
  using Case = SetScrew::Case;
  return std::array{ChoiceName<Case>{Case::unsaid, "not_given", "not given: dynamic if K_A exceeds 1", "unstated"},
                    ChoiceName<Case>{Case::at_rest, "static", "static, without shocks: safety factor at least 1.5"},
                    ChoiceName<Case>{Case::dynamic, "dynamic", "dynamic: safety factor at least 4"}};
}
constexpr auto choices_of(SetScrew::Point) {
  using Point = SetScrew::Point;
  return std::array{ChoiceName<Point>{Point::cup, "cup", "cup point, the usual one"},
                    ChoiceName<Point>{Point::cone, "cone", "cone point: 1.07 of a cup point"},
                    ChoiceName<Point>{Point::flat, "flat", "flat point: 0.92"},
                    ChoiceName<Point>{Point::dog, "dog", "dog point: 0.92"},
                    ChoiceName<Point>{Point::oval, "oval", "oval point: 0.90"}};
}

}  // namespace loadpath::shaft
