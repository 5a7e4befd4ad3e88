// Two wheels pressed together that drive each other by friction: cylindrical, grooved and bevel wheels.
//
// Decides the force that presses them together by a safety factor against slip, the line load and the Hertzian
// pressure of their contact, the forces on both shafts and the torque at which they slip. Coefficients of friction by
// material are the lowest of [Lueger], for dry rims on cast iron. Creep lowers the speed and not the torque. Forces:
// the normal force separates the wheels, F_t is against the rotation of the driving wheel and with that of the driven
// one; axial forces push bevel wheels away from the apex. Grooves: a share c_r of the flank friction opposes pressing
// in. Not covered: wear, heating, the sliding in deep grooves and along a cone whose apexes do not meet, wheels in
// rings, crowned and point contacts, losses by rolling.
#pragma once

#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <vector>

namespace loadpath::drive {

/// A force of the wheels on one of the shafts, with those that act at the same time.
template <class Result>
constexpr auto on_a_shaft(Force Result::*at, const char* key, const char* doc, const char* with) {
  return Field<Result, Force>{at, key, N, doc}.load().with(with).holding("K_A");
}

struct FrictionWheels {
  static constexpr auto id = "drive.friction_wheels";
  static constexpr auto title = "Friction wheels";
  static constexpr auto scope =
      "Pressing force, safety against slip, line load and Hertzian pressure, speeds with creep and shaft forces of a "
      "pair of cylindrical, grooved or bevel friction wheels; wear and heating of the rims are not covered.";
  static constexpr auto source = "[Artobolevsky], [Lueger], [Hertz]";
  static constexpr auto headline = "F_p = {F_p}";
  static constexpr auto details = "i = {i}, safety against slip S_R = {S_R}, line load q = {q}";
  static constexpr auto synonyms =
      "friction wheel, friction wheels, friction drive, friction gearing, traction drive, roller drive, grooved "
      "friction wheel, bevel friction wheel, slip, creep, contact pressure, Reibrad, Reibräder, Reibradgetriebe, "
      "Keilräder, "
      "Anpresskraft, Rutschsicherheit, фрикционная передача, фрикционные катки, сила прижатия, коэффициент сцепления";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Friction wheels of a drum"

[wheels]
calculator = "drive.friction_wheels"
P = "1.5 kW"
K_A = 1.25
n_1 = "700 rpm"
d_1 = "200 mm"
d_2 = "600 mm"
epsilon = 0.02
b = "80 mm"
pair = "leather"
q_adm = "30 N/mm"
)";

  enum class Shape { cylindrical, grooved, bevel };
  enum class Pair { unsaid, cast_iron, paper, leather, wood };

  struct Input {
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    double K_A = 1.0;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Shape shape = Shape::cylindrical;
    Length d_1 = unset<Length>, d_2 = unset<Length>;
    double epsilon = 0.0;
    double alpha = unset<double>, c_r = 0.5;
    Whole z = 1;
    double Sigma = 90.0 * deg.one;
    Length b = unset<Length>;
    Pair pair = Pair::unsaid;
    double mu = unset<double>;
    double S_min = 1.5;
    Force F_p = unset<Force>;
    Stiffness q_adm = unset<Stiffness>;
    Stress p_adm = unset<Stress>;
    Stress E_1 = unset<Stress>, E_2 = unset<Stress>;
    double nu_1 = 0.3, nu_2 = 0.3;
  };
  static constexpr Fields inputs{
      Field{&Input::P, "P", kW, "power at the driving wheel, mean over the cycle"}
          .at_least_that_of_source("shafts[#].P")
          .load()
          .positive()
          .usually(0.001, 200)
          .may_be_missing(),
      Field{&Input::T_1, "T_1", N_m, "torque at the driving wheel, replaces P"}
          .load()
          .at_least_that_of_source("shafts[#].T")
          .positive()
          .may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the power includes it)"}
          .at_least(1)
          .usually(1, 3)
          .factor(),
      Field{&Input::n_1, "n_1", rpm, "speed of the driving wheel"}
          .positive()
          .near_that_of_source("shafts[#].n")
          .usually(1, 2e4),
      Choice{&Input::shape, "shape", "shape of the wheels"}.may_be_missing(),
      Field{&Input::d_1, "d_1", mm, "mean contact diameter of the driving wheel"}.positive().usually(5, 3000),
      Field{&Input::d_2, "d_2", mm, "mean contact diameter of the driven wheel"}.positive().usually(5, 5000),
      Field{&Input::epsilon, "epsilon", ratio, "creep (slip) of the wheels; omitted: none"}.within(0, 0.2).usually(
          0, 0.05),
      Field{&Input::alpha, "alpha", deg, "half of the groove angle, of grooved wheels"}
          .within(1, 60)
          .usually(10, 25)
          .may_be_missing(),
      Count{&Input::z, "z", 1, 20, "number of grooves, of grooved wheels"}.may_be_missing(),
      Field{&Input::c_r, "c_r", ratio,
            "proportion of flank friction that opposes the pressing force: 0.5 by Lueger, 1 for wheels at rest"}
          .within(0, 1),
      Field{&Input::Sigma, "Sigma", deg, "angle of the shafts, of bevel wheels"}.within(1, 170),
      Field{&Input::b, "b", mm, "contact length along a rim, cone or flank of a groove"}
          .positive()
          .usually(2, 500)
          .findable("R20"),
      Choice{&Input::pair, "pair", "material of the softer rim, dry on cast iron, for mu"}.may_be_missing(),
      Field{&Input::mu, "mu", ratio, "coefficient of friction of the rims, replaces pair"}
          .within(0.01, 1.2)
          .usually(0.03, 0.75)
          .may_be_missing(),
      Field{&Input::S_min, "S_min", ratio, "required safety factor against slip, 1.5 to 2"}
          .at_least(1)
          .usually(1.2, 3)
          .customarily_at_least(1.5),
      Field{&Input::F_p, "F_p", N,
            "force that presses the wheels together: along the line of centres, of bevel wheels along the driving "
            "shaft; omitted: the minimum"}
          .positive()
          .may_be_missing(),
      Field{&Input::q_adm, "q_adm", N_per_mm, "allowable line load: normal force per length of contact"}
          .positive()
          .usually(0.5, 3000)
          .may_be_missing(),
      Field{&Input::p_adm, "p_adm", MPa, "allowable Hertzian pressure of the weaker rim"}
          .positive()
          .usually(0.5, 3000)
          .may_be_missing(),
      Field{&Input::E_1, "E_1", GPa, "modulus of elasticity of the driving wheel, for the Hertzian pressure"}
          .positive()
          .usually(0.001, 700)
          .may_be_missing(),
      Field{&Input::E_2, "E_2", GPa, "modulus of elasticity of the driven wheel, for the Hertzian pressure"}
          .positive()
          .usually(0.001, 700)
          .may_be_missing(),
      Field{&Input::nu_1, "nu_1", ratio, "Poisson's ratio of the driving wheel"}.within(0, 0.5),
      Field{&Input::nu_2, "nu_2", ratio, "Poisson's ratio of the driven wheel"}.within(0, 0.5)};

  struct Result {
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Speed v = unset<Speed>;
    Length a = unset<Length>;
    double delta_1 = unset<double>, delta_2 = unset<double>;
    double mu = unset<double>;
    Force F_t = unset<Force>, F_pmin = unset<Force>, F_p = unset<Force>, F_n = unset<Force>;
    double mu_req = unset<double>, S_R = unset<double>;
    Moment T_R = unset<Moment>;
    Force F_r1 = unset<Force>, F_a1 = unset<Force>, F_r2 = unset<Force>, F_a2 = unset<Force>;
    ShaftLoad shaft_1, shaft_2;
    Stiffness q = unset<Stiffness>;
    Stress p_H = unset<Stress>;
    Length b_H = unset<Length>, b_min = unset<Length>;
    double u_S = unset<double>, u_p = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 with creep"},
      Field{&Result::n_2, "n_2", rpm, "speed of the driven wheel"},
      Field{&Result::v, "v", m_per_s, "speed of the driving rim"},
      Field{&Result::a, "a", mm, "centre distance of parallel shafts"}.where_it_applies(),
      Field{&Result::delta_1, "delta_1", deg, "half cone angle of the driving bevel wheel"}.where_it_applies(),
      Field{&Result::delta_2, "delta_2", deg, "half cone angle of the driven bevel wheel"}.where_it_applies(),
      Field{&Result::mu, "mu", ratio, "coefficient of friction"},
      Field{&Result::F_t, "F_t", N, "tangential force at the rims, with K_A"}
          .load()
          .with("F_r1|F_r2, F_a1|F_a2, shaft_1.T|shaft_2.T")
          .holding("K_A"),
      Field{&Result::F_pmin, "F_pmin", N, "minimum pressing force, with the required safety against slip"},
      Field{&Result::F_p, "F_p", N, "force that presses the wheels together"},
      Field{&Result::F_n, "F_n", N, "normal force between the rims, of grooved wheels the sum over the flanks"},
      Field{&Result::mu_req, "mu_req", ratio, "required coefficient of friction"},
      Field{&Result::S_R, "S_R", ratio, "safety factor against slip"},
      Field{&Result::T_R, "T_R", N_m, "torque of the driving wheel at which the wheels slip"},
      on_a_shaft(&Result::F_r1, "F_r1", "separating force, perpendicular to the driving shaft", "F_t, F_a1, shaft_1.T"),
      on_a_shaft(&Result::F_a1, "F_a1", "axial force on the driving wheel, away from the apex", "F_t, F_r1, shaft_1.T"),
      on_a_shaft(&Result::F_r2, "F_r2", "separating force, perpendicular to the driven shaft", "F_t, F_a2, shaft_2.T"),
      on_a_shaft(&Result::F_a2, "F_a2", "axial force on the driven wheel, away from the apex", "F_t, F_r2, shaft_2.T"),
      Group{&Result::shaft_1, "shaft_1", "shaft load on the driving shaft, turning counter-clockwise, for load"}
          .handed_over(),
      Group{&Result::shaft_2, "shaft_2", "shaft load on the driven shaft, turning clockwise, for load"}.handed_over(),
      Field{&Result::q, "q", N_per_mm, "line load: normal force per length of contact"},
      Field{&Result::p_H, "p_H", MPa, "maximum Hertzian pressure"}.where_it_applies(),
      Field{&Result::b_H, "b_H", mm, "half contact width"}.where_it_applies(),
      Field{&Result::b_min, "b_min", mm, "minimum contact length by q_adm and p_adm"}.where_it_applies(),
      Field{&Result::u_S, "u_S", ratio, "slip: required / actual pressing force"}.check(),
      Field{&Result::u_p, "u_p", ratio, "contact: line load or Hertzian pressure / allowable value, the larger"}.check(
          "q_adm, p_adm")};

  static bool cones_meet(const Input& in);
  static bool ends_before_axis(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.P) != is_set(in.T_1); }, "P, T_1", "give either P or T_1"},
      Rule<Input>{[](const Input& in) { return is_set(in.mu) != (in.pair != Pair::unsaid); }, "mu, pair",
                  "give either the coefficient of friction mu or the pair of materials"},
      Rule<Input>{[](const Input& in) { return is_set(in.alpha) == (in.shape == Shape::grooved); }, "alpha, shape",
                  "grooved wheels, and only these, need the half groove angle alpha"},
      Rule<Input>{[](const Input& in) { return in.z == 1 || in.shape == Shape::grooved; }, "z, shape",
                  "only grooved wheels have a number of grooves: shape = \"grooved\""},
      Rule<Input>{&cones_meet, "Sigma, d_1, d_2",
                  "a wheel would be a disc or a ring at this shaft angle: reduce Sigma, or the ratio of the diameters"},
      Rule<Input>{&ends_before_axis, "b, alpha, Sigma, d_1, d_2",
                  "the contact would reach beyond the axis of a wheel or the apex of the cones: reduce b"},
      Rule<Input>{[](const Input& in) { return is_set(in.E_1) == is_set(in.E_2); }, "E_1, E_2",
                  "give the modulus of elasticity of both wheels"},
      Rule<Input>{[](const Input& in) { return !is_set(in.p_adm) || is_set(in.E_1); }, "p_adm, E_1, E_2",
                  "the Hertzian pressure needs E_1 and E_2; soft rims are compared by their line load q_adm"},
      // It does not name b: it is asked before the search, where only a searched b is missing.
      Rule<Input>{[](const Input& in) { return is_set(in.b) || is_set(in.q_adm) || is_set(in.p_adm); }, "q_adm, p_adm",
                  "without b, the search for it needs a limit: give q_adm of soft rims, or p_adm with E_1 and E_2"}};

  static double most_length_of_cylinders(const Input& in);
  static double most_length_of_cones(const Input& in);
  static double most_length_of_flanks(const Input& in);
  static double most_line_load(const Input& in);
  static double most_pressure(const Input& in);
  static double most_speed(const Input& in);
  static constexpr std::array bounds{
      Bound<Input>{"b", "the smaller diameter", &most_length_of_cylinders},
      Bound<Input>{"b", "a third of the cone distance", &most_length_of_cones},
      Bound<Input>{"b", "grooves as deep as a quarter of the smaller wheel", &most_length_of_flanks},
      Bound<Input>{"mu", "dry soft rims", [](const Input&) { return 0.75; }},
      Bound<Input>{"q_adm", "soft rims", &most_line_load},
      Bound<Input>{"p_adm", "soft rims", &most_pressure},
      Bound<Input>{"n_1", "a rim speed of 35 m/s", &most_speed}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"P", "mean"}};
  static Applies grooved(const Input& in) { return in.shape == Shape::grooved ? Applies::unseen : Applies::no; }
  static constexpr std::array modes{
      Mode<Input>{"grip", "slip of the wheels", &always<Input>}.judged_by("u_S"),
      Mode<Input>{"contact", "contact pressure of the rims", &always<Input>}.judged_by("u_p").asking(
          "give q_adm of soft rims, or p_adm with E_1 and E_2"),
      Mode<Input>{"grooves", "sliding and wear in the grooves", &grooved}.special(),
      Mode<Input>{"wear", "wear and heating of the rims", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  /// The wheels with their forces, and the contact.
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(FrictionWheels::Shape) {
  using Shape = FrictionWheels::Shape;
  return std::array{ChoiceName<Shape>{Shape::cylindrical, "cylindrical", "cylinders on parallel shafts"},
                    ChoiceName<Shape>{Shape::grooved, "grooved", "wheels with V-grooves on parallel shafts"},
                    ChoiceName<Shape>{Shape::bevel, "bevel", "cones with a common apex, on shafts that intersect"}};
}
constexpr auto choices_of(FrictionWheels::Pair) {
  using Pair = FrictionWheels::Pair;
  return std::array{ChoiceName<Pair>{Pair::unsaid, "", "not given"},
                    ChoiceName<Pair>{Pair::cast_iron, "cast_iron", "cast iron: mu = 0.10 (to 0.15)"},
                    ChoiceName<Pair>{Pair::paper, "paper", "paper: mu = 0.15 (to 0.20)"},
                    ChoiceName<Pair>{Pair::leather, "leather", "leather: mu = 0.20 (to 0.30)"},
                    ChoiceName<Pair>{Pair::wood, "wood", "wood: mu = 0.30 (to 0.50)"}};
}

}  // namespace loadpath::drive
