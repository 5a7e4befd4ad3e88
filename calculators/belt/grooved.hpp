// A drive of round belts in grooves, or of one V-ribbed belt: wedge friction, tensions, number of belts or ribs, shaft
// load.
//
// Decides the number of belts or ribs by the allowable tension of one of them and by Euler's condition with the wedge
// friction mu / sin(phi/2) of the grooves, or by the power that the manufacturer states for a rib: there is no standard
// rating of V-ribbed belts (ISO 9982 has dimensions only). Tensions are those of one belt or rib, shaft loads of all.
// Not covered: crossed belts, more than two pulleys (belt.course), stocked lengths, belt life. The linked shaft load is
// the larger resultant, in operation or at standstill.
#pragma once

#include "calculators/belt/geometry.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/row_kind.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <vector>

namespace loadpath::belt {

struct Grooved {
  static constexpr auto id = "belt.grooved";
  static constexpr auto title = "Round or V-ribbed belt drive";
  static constexpr auto scope =
      "Number of round belts or of ribs of a V-ribbed belt, tensions by the Euler-Eytelwein equation with the wedge "
      "friction of the grooves, initial tension and shaft load of an open two-pulley drive; the power rating of a rib "
      "is that of its manufacturer, belt life is not covered.";
  static constexpr auto source = "[B40], [ISO9982], [Tribology-V]";
  static constexpr auto headline = "z = {z}";
  static constexpr auto details = "L = {L}, a = {a}, initial tension S_0 = {S_0} per belt or rib, shaft load R = {R}";
  static constexpr auto synonyms =
      "round belt, rope drive, V-ribbed belt, poly-V belt, PH, PJ, PK, PL, PM, ISO 9982, wedge friction, groove angle, "
      "Rundriemen, Keilrippenriemen, Seiltrieb, belt, круглый ремень, поликлиновой ремень, канатная передача";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Roller drive with round belts"

[rollers]
calculator = "belt.grooved"
P = "150 W"
K_A = 1.2
n_1 = "1400 rpm"
d_1 = "80 mm"
d_2 = "160 mm"
a = "300 mm"
mu = 0.4
phi = "40 deg"
d_b = "6 mm"
rho = "1200 kg/m^3"
sigma_adm = "4 MPa"
E_b = "15 MPa"
d_min = "60 mm"
v_max = "20 m/s"
)";

  enum class Kind { round, ribbed };
  enum class Tensioning { fixed, constant_force };

  struct Input {
    Kind kind = Kind::round;
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    double K_A = 1.0;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Length d_1 = unset<Length>, d_2 = unset<Length>, a = unset<Length>, L = unset<Length>;
    double epsilon = 0.01;
    double mu = unset<double>, phi = unset<double>;
    Whole z = 0;
    Length d_b = unset<Length>;
    Density rho = unset<Density>;
    Stress sigma_adm = unset<Stress>, E_b = unset<Stress>;
    LineDensity q = unset<LineDensity>;
    Force S_adm = unset<Force>;
    Power P_R = unset<Power>;
    Length p_r = unset<Length>, d_min = unset<Length>;
    Speed v_max = unset<Speed>;
    Force S_0 = unset<Force>;
    Tensioning tensioning = Tensioning::fixed;
  };
  static constexpr Fields inputs{
      RowKind<Input, Kind>{&Input::kind, "kind", "belt type", "ribbed_belt"},
      Field{&Input::P, "P", kW, "power at the driving pulley, mean over the cycle"}
          .at_least_that_of_source("shafts[#].P")
          .load()
          .positive()
          .usually(0.001, 3000)
          .may_be_missing(),
      Field{&Input::T_1, "T_1", N_m, "torque at the driving pulley, replaces P"}
          .load()
          .at_least_that_of_source("shafts[#].T")
          .positive()
          .may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "service factor (1 if the power includes it)"}
          .at_least(1)
          .usually(1, 3)
          .factor(),
      Field{&Input::n_1, "n_1", rpm, "speed of the driving pulley"}
          .positive()
          .near_that_of_source("shafts[#].n")
          .usually(10, 2e4),
      Field{&Input::d_1, "d_1", mm, "diameter of the driving pulley, at the tension line of the belt"}
          .positive()
          .at_least_that_of_source("d")
          .usually(5, 5000),
      Field{&Input::d_2, "d_2", mm, "diameter of the driven pulley, at the tension line of the belt"}
          .positive()
          .usually(5, 5000),
      Field{&Input::a, "a", mm, "centre distance"}.positive().usually(10, 5e4).may_be_missing(),
      Field{&Input::L, "L", mm, "belt length at the tension line, replaces a"}
          .positive()
          .usually(50, 1e5)
          .may_be_missing(),
      Field{&Input::epsilon, "epsilon", ratio, "slip"}.within(0, 0.1).usually(0, 0.05),
      Field{&Input::mu, "mu", ratio, "coefficient of friction of the belt on the groove sides"}
          .within(0.01, 1.5)
          .usually(0.1, 1),
      Field{&Input::phi, "phi", deg, "groove angle; omitted: 40° of V-ribbed belts, a smooth rim for round belts"}
          .within(20, 180)
          .usually(30, 90)
          .may_be_missing(),
      Count{&Input::z, "z", 0, 100, "number of belts or ribs; 0: as required"}.may_be_missing(),
      Field{&Input::d_b, "d_b", mm, "diameter of a round belt"}.positive().usually(1, 60).may_be_missing(),
      Field{&Input::rho, "rho", kg_per_m3, "density of a round belt"}.positive().usually(500, 2500).may_be_missing(),
      Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable stress of a round belt (safety factor included)"}
          .positive()
          .usually(0.5, 30)
          .may_be_missing(),
      Field{&Input::E_b, "E_b", MPa,
            "bending modulus of a round belt; if given, bending at the smaller pulley is included"}
          .positive()
          .usually(1, 5000)
          .may_be_missing(),
      Field{&Input::q, "q", kg_per_m, "mass per length of one belt or rib, replaces d_b and rho"}
          .positive()
          .usually(0.001, 5)
          .from("ribbed_belt", "q")
          .where_it_has(),
      Field{&Input::S_adm, "S_adm", N, "allowable tension of one belt or rib (safety factor included)"}
          .positive()
          .usually(1, 2e4)
          .may_be_missing(),
      Field{&Input::P_R, "P_R", kW,
            "power rating of one belt or rib by its manufacturer, with the factors of wrap and length"}
          .positive()
          .usually(0.001, 50)
          .may_be_missing(),
      Field{&Input::p_r, "p_r", mm, "rib pitch"}.positive().usually(1, 20).from("ribbed_belt", "p_r"),
      Field{&Input::d_min, "d_min", mm, "minimum pulley diameter of the belt"}.positive().usually(5, 1000).from(
          "ribbed_belt", "d_min"),
      Field{&Input::v_max, "v_max", m_per_s, "maximum belt speed"}
          .positive()
          .usually(5, 80)
          .from("ribbed_belt", "v_max")
          .where_it_has(),
      Field{&Input::S_0, "S_0", N, "initial tension of one belt or rib at standstill; omitted: the minimum"}
          .positive()
          .may_be_missing(),
      Choice{&Input::tensioning, "tensioning", "tensioning method"}.may_be_missing()};

  struct Result {
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Speed v = unset<Speed>;
    Length a = unset<Length>, L = unset<Length>, l_s = unset<Length>;
    double gamma = unset<double>, alpha_1 = unset<double>, alpha_2 = unset<double>;
    Force F_t = unset<Force>;
    double mu_w = unset<double>, m_e = unset<double>;
    Force S_all = unset<Force>, S_b = unset<Force>, F_c = unset<Force>, S_N = unset<Force>;
    double z_0 = unset<double>;
    Whole z = 0;
    Length b = unset<Length>;
    Force S_0_min = unset<Force>, S_0 = unset<Force>, S_1 = unset<Force>, S_2 = unset<Force>;
    double mu_req = unset<double>;
    Force R_0 = unset<Force>, R_x = unset<Force>, R_y = unset<Force>, R = unset<Force>;
    double theta_R = unset<double>;
    ShaftLoad shaft_1, shaft_2;
    AngularSpeed f_B = unset<AngularSpeed>;
    double u_S = unset<double>, u_T = unset<double>, u_P = unset<double>, u_b = unset<double>;
    double x_d = unset<double>, x_v = unset<double>, x_b = unset<double>;
    Length g_x = unset<Length>;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 with slip"},
      Field{&Result::n_2, "n_2", rpm, "speed of the driven pulley"},
      Field{&Result::v, "v", m_per_s, "belt speed"},
      Field{&Result::a, "a", mm, "centre distance"},
      Field{&Result::L, "L", mm, "belt length at the tension line"},
      Field{&Result::l_s, "l_s", mm, "free span length"},
      Field{&Result::gamma, "gamma", deg, "span angle to the line of centres"},
      Field{&Result::alpha_1, "alpha_1", deg, "wrap angle, driving pulley"},
      Field{&Result::alpha_2, "alpha_2", deg, "wrap angle, driven pulley"},
      Field{&Result::F_t, "F_t", N, "effective pull of all belts or ribs, with K_A"}.holding("K_A"),
      Field{&Result::mu_w, "mu_w", ratio, "wedge coefficient of friction in the groove"},
      Field{&Result::m_e, "m_e", ratio, "maximum tension ratio, without centrifugal tension"},
      Field{&Result::S_all, "S_all", N, "allowable tension of one belt or rib"},
      Field{&Result::S_b, "S_b", N, "tension that corresponds to the bending stress at the smaller pulley"},
      Field{&Result::F_c, "F_c", N, "centrifugal tension of one belt or rib"},
      Field{&Result::z_0, "z_0", ratio, "required number of belts or ribs, not rounded"},
      Count{&Result::z, "z", 0, 100, "number of belts or ribs; at most 100 are found"},
      Field{&Result::b, "b", mm, "width of the ribbed belt"},
      Field{&Result::S_0_min, "S_0_min", N, "minimum initial tension of one belt or rib at standstill"},
      Field{&Result::S_0, "S_0", N, "initial tension of one belt or rib at standstill"},
      Field{&Result::S_1, "S_1", N, "tight side tension of one belt or rib"},
      Field{&Result::S_2, "S_2", N, "slack side tension of one belt or rib"},
      Field{&Result::mu_req, "mu_req", ratio, "utilised coefficient of friction on the groove sides"},
      pull(&Result::R_0, "R_0", "shaft load at standstill, along the line of centres"),
      pull(&Result::R_x, "R_x", "shaft load in operation, toward the other pulley", "R_y, shaft_1.T|shaft_2.T"),
      pull(&Result::R_y, "R_y", "shaft load in operation, to the side of the tight span", "R_x, shaft_1.T|shaft_2.T"),
      pull(&Result::R, "R", "shaft load in operation"),
      Field{&Result::theta_R, "theta_R", deg, "direction of the shaft load to the line of centres"},
      Group{&Result::shaft_1, "shaft_1",
            "maximum shaft load on the driving shaft, in operation or at standstill, for load"}
          .handed_over(),
      Group{&Result::shaft_2, "shaft_2",
            "maximum shaft load on the driven shaft, in operation or at standstill, for load"}
          .handed_over(),
      Field{&Result::f_B, "f_B", Hz, "flex rate of the belt"},
      Field{&Result::S_N, "S_N", N,
            "tension of one belt or rib available for the effective pull, without bending and centrifugal tension"}
          .limit(1e-9, 1e9, "S_adm, sigma_adm")
          .criterion(),
      Field{&Result::u_S, "u_S", ratio, "friction: required / actual initial tension"}.check(),
      Field{&Result::u_T, "u_T", ratio, "strength: tight side tension with bending / allowable tension"}.check(
          "S_adm, sigma_adm"),
      Field{&Result::u_P, "u_P", ratio, "rating: design power / power rating of all belts or ribs"}.check("P_R"),
      Field{&Result::u_b, "u_b", ratio, "bending at the smaller pulley: bending stress / allowable stress"}.check(
          "E_b"),
      Field{&Result::x_d, "x_d", ratio, "minimum pulley diameter / diameter of the smaller pulley"}
          .limit(0, 1, "d_min")
          .criterion(),
      Field{&Result::x_v, "x_v", ratio, "belt speed / maximum belt speed"}.limit(0, 1, "v_max").sizeless(),
      Field{&Result::x_b, "x_b", ratio, "width of the ribs / diameter of the smaller pulley (limit set by loadpath)"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::g_x, "g_x", mm, "clearance between the belt on the two pulleys"}.limit(0, 1e6).criterion()};

  static bool has_mass(const Input& in) { return is_set(in.q) || (is_set(in.d_b) && is_set(in.rho)); }
  static bool has_capacity(const Input& in) {
    return is_set(in.S_adm) || is_set(in.P_R) || (is_set(in.sigma_adm) && is_set(in.d_b));
  }
  static FieldFault no_capacity(const Input& in);
  static bool pulleys_clear(const Input& in);
  static FieldFault pulleys_overlap(const Input& in);
  static bool belt_is_thin(const Input& in) { return !is_set(in.d_b) || in.d_b < 0.5 * min(in.d_1, in.d_2); }
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.P) != is_set(in.T_1); }, "P, T_1", "give either P or T_1"},
      Rule<Input>{[](const Input& in) { return is_set(in.a) != is_set(in.L); }, "a, L",
                  "give either the centre distance a or the belt length L"},
      Rule<Input>{&pulleys_clear, "a, L, d_1, d_2", "the pulleys must not overlap", &pulleys_overlap},
      Rule<Input>{&has_mass, "q, d_b, rho", "give the mass per length q, or d_b and rho of a round belt"},
      Rule<Input>{&has_capacity, "S_adm, sigma_adm, d_b, P_R",
                  "give the allowable tension S_adm, or sigma_adm and d_b of a round belt, or the rating P_R",
                  &no_capacity},
      Rule<Input>{[](const Input& in) { return !(is_set(in.S_adm) && is_set(in.sigma_adm)); }, "S_adm, sigma_adm",
                  "give either S_adm or sigma_adm"},
      Rule<Input>{[](const Input& in) { return !is_set(in.sigma_adm) || is_set(in.d_b); }, "sigma_adm, d_b",
                  "the allowable stress sigma_adm needs the belt diameter d_b"},
      Rule<Input>{[](const Input& in) {
                    return !is_set(in.E_b) || is_set(in.sigma_adm) || (is_set(in.S_adm) && is_set(in.d_b));
                  },
                  "E_b, sigma_adm, S_adm, d_b",
                  "the bending modulus E_b needs the allowable stress sigma_adm, or S_adm and d_b"},
      Rule<Input>{[](const Input& in) { return in.kind == Kind::round || !is_set(in.d_b); }, "kind, d_b",
                  "a V-ribbed belt has no diameter d_b: give q and S_adm or P_R of one rib"},
      Rule<Input>{&belt_is_thin, "d_b, d_1, d_2", "the belt must be thinner than half of the smaller pulley"}};

  static double most_rating(const Input& in);
  static double least_bend(const Input& in);
  static double most_speed(const Input& in) { return in.kind == Kind::round ? 40.0 : 60.0; }  // m/s, from memory
  static double groove_angle(const Input& in) { return in.kind == Kind::ribbed ? 2.0 * pi / 9.0 : unset<double>; }
  static double least_centre_distance(const Input& in);
  static double most_centre_distance(const Input& in);
  static double least_length(const Input& in);
  static constexpr std::array bounds{
      Bound<Input>{"P_R", "a pull of 60 N per mm of rib pitch or 10 N/mm^2 of a round belt", &most_rating},
      Bound<Input>{"d_min", "a bend of 5 belt diameters", &least_bend}.least(),
      Bound<Input>{"v_max", "this type of belt", &most_speed},
      Bound<Input>{"phi", "ribs of ISO 9982", &groove_angle},
      Bound<Input>{"phi", "ribs of ISO 9982", &groove_angle}.least(),
      Bound<Input>{"a", "a wrap of 120°", &least_centre_distance}.least(),
      Bound<Input>{"a", "ten times the sum of the diameters", &most_centre_distance},
      Bound<Input>{"L", "a wrap of 120°", &least_length}.least(),
      Bound<Input>{"d_1", "a speed ratio of 7", [](const Input& in) { return in_si(7.0 * in.d_2); }},
      Bound<Input>{"d_2", "a speed ratio of 7", [](const Input& in) { return in_si(7.0 * in.d_1); }}};

  static constexpr bool turns = true;
  static Applies tensioned(const Input& in) { return where(is_set(in.S_adm) || is_set(in.sigma_adm)); }
  static Applies rated(const Input& in) { return where(in.kind == Kind::ribbed || is_set(in.P_R)); }
  static Applies bent(const Input& in) {
    return where(is_set(in.sigma_adm) || (in.kind == Kind::round && is_set(in.S_adm)));
  }
  static Applies ribbed(const Input& in) { return where(is_set(in.p_r)); }
  static constexpr std::array meanings{Meaning{"P", "mean"}};
  static constexpr std::array modes{
      Mode<Input>{"grip", "belt slip in the grooves", &always<Input>}.judged_by("u_S"),
      Mode<Input>{"strength", "tensile strength, tight span", &tensioned}.judged_by("u_T, S_N"),
      Mode<Input>{"rating", "power rating of the belts or ribs", &rated}.judged_by("u_P"),
      Mode<Input>{"bending", "bending at the smaller pulley", &bent}.judged_by("u_b"),
      Mode<Input>{"width", "belt width within the pulleys", &ribbed}.judged_by("x_b").of_shape(),
      Mode<Input>{"room", "clearance between the pulleys", &always<Input>}.judged_by("g_x").of_shape(),
      Mode<Input>{"pulley", "minimum pulley diameter", &always<Input>}.judged_by("x_d").of_shape().wanting("d_min"),
      Mode<Input>{"speed", "maximum belt speed", &always<Input>}.judged_by("x_v").wanting("v_max"),
      Mode<Input>{"fatigue", "belt fatigue life (flex rate)", &unseen<Input>}.special(),
      Mode<Input>{"radial_load", "radial load on the motor shaft", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Grooved::Kind) {
  using Kind = Grooved::Kind;
  return std::array{ChoiceName<Kind>{Kind::round, "round", "round belts or ropes in grooves"},
                    ChoiceName<Kind>{Kind::ribbed, "ribbed", "V-ribbed belt (PH, PJ, PK, PL, PM)"}};
}
constexpr auto choices_of(Grooved::Tensioning) {
  using Tensioning = Grooved::Tensioning;
  return std::array{
      ChoiceName<Tensioning>{Tensioning::fixed, "fixed", "centres that are fixed when running"},
      ChoiceName<Tensioning>{Tensioning::constant_force, "constant_force", "weight or spring with constant tension"}};
}

}  // namespace loadpath::belt
