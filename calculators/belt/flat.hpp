// A flat belt drive, open, crossed or between shafts at right angles: course, tensions by friction, width of the belt,
// shaft load.
//
// Decides the width by the allowable stress of the belt and the initial tension by Euler's condition at the smaller
// wrap, with the part of the tension that turns the belt around (centrifugal) kept out of the friction. Tensions: S_1
// tight, S_2 slack; the mean of the two stays that of standstill on fixed centres, while a tensioner with a constant
// force lets it rise by the centrifugal part. On a pivoted motor base the moments of weight and spans about the pivot
// balance, and the mean of the tensions rises with the load if the slack span has the longer arm. Life: the S-N curve
// of the belt at the tight span on the smaller pulley. Not covered: rollers on the belt (belt.course), crowning, guide
// pulleys between skew shafts. The linked shaft load is the larger resultant, in operation or at standstill.
#pragma once

#include "calculators/belt/driven.hpp"
#include "calculators/belt/geometry.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <vector>

namespace loadpath::belt {

struct Flat {
  static constexpr auto id = "belt.flat";
  static constexpr auto title = "Flat belt drive";
  static constexpr auto scope =
      "Length or centre distance, wrap angles, speeds with slip, tensions by the Euler-Eytelwein equation with "
      "centrifugal tension, belt width, initial tension (also of a pivoted motor base) and shaft load of an open, "
      "crossed or quarter-turn flat belt drive at 5 to 30 m/s (synthetic belts to 100 m/s), belt life by an S-N curve; "
      "idlers are not covered (belt.course).";
  static constexpr auto source = "[B40], [Firgelli], [Shigley-17], [Shigley-17-3]";
  static constexpr auto headline = "b = {b}";
  static constexpr auto details = "L = {L}, a = {a}, initial tension S_0 = {S_0}, shaft load R = {R}";
  static constexpr auto synonyms =
      "flat belt, belt drive, Euler-Eytelwein, capstan equation, wrap angle, initial tension, crossed belt, "
      "pivoted motor base, motor base, quarter-turn belt, "
      "open belt, Flachriemen, Riementrieb, Umschlingungswinkel, Vorspannung, belt, плоскоремённая передача, "
      "ремень, формула Эйлера";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Fan drive with a flat belt"

[fan_belt]
calculator = "belt.flat"
P = "15 kW"
K_A = 1.2
n_1 = "1450 rpm"
d_1 = "200 mm"
d_2 = "500 mm"
a = "1200 mm"
mu = 0.4
kind = "synthetic"
delta = "2.5 mm"
rho = "1100 kg/m^3"
sigma_adm = "6 MPa"
E_b = "40 MPa"
)";

  enum class Kind { conventional, synthetic };
  enum class Tensioning { fixed, constant_force, pivoted_base };
  enum class Rotation { one, both };

  struct Input {
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    double K_A = 1.0;
    AngularSpeed n_1 = unset<AngularSpeed>, n_2_set = unset<AngularSpeed>;
    double i_set = unset<double>;
    Length d_1 = unset<Length>, d_2 = unset<Length>, a = unset<Length>, L = unset<Length>;
    Arrangement arrangement = Arrangement::open;
    double epsilon = 0.01;
    double mu = unset<double>;
    Kind kind = Kind::conventional;
    Length delta = unset<Length>, b = unset<Length>;
    Density rho = unset<Density>;
    Stress sigma_adm = unset<Stress>, E_b = unset<Stress>;
    Force S_0 = unset<Force>;
    Tensioning tensioning = Tensioning::fixed;
    Rotation rotation = Rotation::one;
    Mass m_m = unset<Mass>;
    Length a_G = unset<Length>, h_P = unset<Length>, x_P = unset<Length>;
    Stress sigma_f = unset<Stress>;
    double m_f = unset<double>, N_f = 1e7;
    Time L_req = unset<Time>;
  };
  static constexpr auto inputs = join(
      Fields{Field{&Input::P, "P", kW, "power at the driving pulley, mean over the cycle"}
                 .at_least_that_of_source("shafts[#].P")
                 .load()
                 .positive()
                 .usually(0.01, 3000)
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
             Field{&Input::d_1, "d_1", mm, "diameter of the driving pulley"}
                 .positive()
                 .at_least_that_of_source("d")
                 .same_as_that_of_source("stages[#].d_1, drive.d_1")
                 .usually(10, 5000),
             Field{&Input::d_2, "d_2", mm, "diameter of the driven pulley"}
                 .positive()
                 .same_as_that_of_source("stages[#].d_2, drive.d_2")
                 .usually(10, 5000)
                 .may_be_missing()},
      driven_inputs<Input>(),
      Fields{
          Field{&Input::a, "a", mm, "centre distance"}.positive().usually(10, 5e4).may_be_missing(),
          Field{&Input::L, "L", mm, "inside belt length, replaces a"}.positive().usually(50, 1e5).may_be_missing(),
          Choice{&Input::arrangement, "arrangement", "belt arrangement: open, crossed or quarter-turn"}
              .may_be_missing(),
          Field{&Input::epsilon, "epsilon", ratio, "slip"}.within(0, 0.1).usually(0, 0.05),
          Field{&Input::mu, "mu", ratio, "coefficient of friction of the belt on the pulleys"}
              .within(0.01, 1.5)
              .usually(0.1, 1),
          Choice{&Input::kind, "kind", "belt type, for the maximum speed"}.may_be_missing(),
          Field{&Input::delta, "delta", mm, "belt thickness"}.positive().usually(0.3, 20),
          Field{&Input::b, "b", mm, "belt width"}.positive().usually(5, 2000).searched("R20").may_be_missing(),
          Field{&Input::rho, "rho", kg_per_m3, "belt density"}.positive().usually(500, 2500),
          Field{&Input::sigma_adm, "sigma_adm", MPa, "allowable belt stress (safety factor included)"}
              .positive()
              .usually(0.5, 30),
          Field{&Input::E_b, "E_b", MPa,
                "bending modulus of the belt; if given, bending at the smaller pulley is included"}
              .positive()
              .usually(5, 5000)
              .may_be_missing(),
          Field{&Input::S_0, "S_0", N, "initial tension of a span at standstill; omitted: the minimum"}
              .positive()
              .may_be_missing(),
          Choice{&Input::tensioning, "tensioning", "tensioning method"}.may_be_missing(),
          Choice{&Input::rotation, "rotation", "pivoted base: directions of rotation"}.may_be_missing(),
          Field{&Input::m_m, "m_m", kg, "pivoted base: mass of the motor and the base on the pivot"}
              .positive()
              .usually(0.5, 5000)
              .may_be_missing(),
          Field{&Input::a_G, "a_G", mm, "pivoted base: horizontal distance of their centre of mass from the pivot"}
              .positive()
              .may_be_missing(),
          Field{&Input::h_P, "h_P", mm,
                "pivoted base: distance of the pivot from the line of centres, positive on the side of the tight span"}
              .may_be_missing(),
          Field{&Input::x_P, "x_P", mm,
                "pivoted base: distance of the pivot from the motor axis, along the line of centres toward the "
                "driven pulley"}
              .may_be_missing(),
          Field{&Input::sigma_f, "sigma_f", MPa, "fatigue strength of the belt at N_f bends, tension with bending"}
              .positive()
              .usually(1, 50)
              .may_be_missing(),
          Field{&Input::m_f, "m_f", ratio, "exponent of the S-N curve of the belt (flat belts: 5 to 6)"}
              .within(1, 20)
              .usually(2, 12)
              .may_be_missing(),
          Field{&Input::N_f, "N_f", ratio, "number of bends for which sigma_f is stated"}.within(1, 1e12).usually(1e5,
                                                                                                                  1e9),
          Field{&Input::L_req, "L_req", hour, "required belt life"}.positive().usually(100, 1e5).may_be_missing()});

  struct Result {
    Length d_2 = unset<Length>;
    double i_w = unset<double>, dev_i = unset<double>;
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Speed v = unset<Speed>;
    Length a = unset<Length>, L = unset<Length>, l_s = unset<Length>;
    double gamma = unset<double>, beta_1 = unset<double>, beta_2 = unset<double>, alpha_1 = unset<double>,
           alpha_2 = unset<double>;
    Force F_t = unset<Force>;
    double m_e = unset<double>;
    Stress sigma_b = unset<Stress>, sigma_c = unset<Stress>, sigma_N = unset<Stress>;
    Speed v_opt = unset<Speed>;
    Length b_min = unset<Length>, b = unset<Length>;
    Force F_c = unset<Force>, S_0_min = unset<Force>, S_0 = unset<Force>, S_1 = unset<Force>, S_2 = unset<Force>;
    Length a_1 = unset<Length>, a_2 = unset<Length>;
    double k_S = unset<double>, u_Sr = unset<double>;
    Mass m_min = unset<Mass>;
    Force S_0r = unset<Force>, S_1r = unset<Force>;
    double mu_req = unset<double>;
    Stress sigma_max = unset<Stress>;
    Force R_0 = unset<Force>, R_x = unset<Force>, R_y = unset<Force>, R = unset<Force>;
    double theta_R = unset<double>;
    ShaftLoad shaft_1, shaft_2;
    AngularSpeed f_B = unset<AngularSpeed>;
    double N_B = unset<double>;
    Time L_h = unset<Time>;
    double u_L = unset<double>;
    double u_S = unset<double>, u_sigma = unset<double>, u_b = unset<double>, x_v = unset<double>, x_b = unset<double>;
    Length g_x = unset<Length>;
    Speed v_range = unset<Speed>;
    double x_a = unset<double>, x_q = unset<double>, x_t = unset<double>;
  };
  static constexpr auto results = join(
      driven_results<Result>("diameter of the driven pulley found, of R20"),
      Fields{
          Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 with slip"},
          Field{&Result::n_2, "n_2", rpm, "speed of the driven pulley"},
          Field{&Result::v, "v", m_per_s, "belt speed"},
          Field{&Result::a, "a", mm, "centre distance"},
          Field{&Result::L, "L", mm, "inside belt length"},
          Field{&Result::l_s, "l_s", mm, "free span length"},
          Field{&Result::gamma, "gamma", deg, "span angle to the line of centres, open or crossed belt"},
          Field{&Result::beta_1, "beta_1", deg, "angle at which a quarter-turn belt leaves the driven pulley"},
          Field{&Result::beta_2, "beta_2", deg, "angle at which a quarter-turn belt leaves the driving pulley"},
          Field{&Result::alpha_1, "alpha_1", deg, "wrap angle, driving pulley"},
          Field{&Result::alpha_2, "alpha_2", deg, "wrap angle, driven pulley"},
          Field{&Result::F_t, "F_t", N, "effective pull (circumferential force), with K_A"}.holding("K_A"),
          Field{&Result::m_e, "m_e", ratio, "maximum tension ratio, without centrifugal tension"},
          Field{&Result::sigma_b, "sigma_b", MPa, "bending stress at the smaller pulley"},
          Field{&Result::sigma_c, "sigma_c", MPa, "centrifugal stress"},
          Field{&Result::v_opt, "v_opt", m_per_s, "optimum belt speed (maximum power)"},
          Field{&Result::b_min, "b_min", mm, "minimum belt width: stress and friction at their limits"},
          Field{&Result::b, "b", mm, "belt width"},
          Field{&Result::F_c, "F_c", N, "centrifugal tension"},
          Field{&Result::S_0_min, "S_0_min", N, "minimum initial tension of a span at standstill"},
          Field{&Result::S_0, "S_0", N, "initial tension of a span at standstill"},
          Field{&Result::S_1, "S_1", N, "tight side tension"},
          Field{&Result::S_2, "S_2", N, "slack side tension"},
          Field{&Result::a_1, "a_1", mm, "pivoted base: lever arm of the tight span about the pivot"},
          Field{&Result::a_2, "a_2", mm, "pivoted base: lever arm of the slack span about the pivot"},
          Field{&Result::k_S, "k_S", ratio,
                "pivoted base: increase of the mean tension / half of the effective pull (negative: the load slackens "
                "the belt)"},
          Field{&Result::m_min, "m_min", kg, "pivoted base: minimum mass of the motor and the base against slip"},
          Field{&Result::S_0r, "S_0r", N, "minimum initial tension, reversed rotation"},
          Field{&Result::S_1r, "S_1r", N, "tight side tension, reversed rotation"},
          Field{&Result::mu_req, "mu_req", ratio, "utilised coefficient of friction"},
          Field{&Result::sigma_max, "sigma_max", MPa, "maximum stress: tight side at the smaller pulley"},
          pull(&Result::R_0, "R_0", "shaft load at standstill, along the line of centres"),
          pull(&Result::R_x, "R_x", "shaft load in operation, toward the other pulley", "R_y, shaft_1.T|shaft_2.T"),
          pull(&Result::R_y, "R_y", "shaft load in operation, to the side of the tight span",
               "R_x, shaft_1.T|shaft_2.T"),
          pull(&Result::R, "R", "shaft load in operation"),
          Field{&Result::theta_R, "theta_R", deg, "direction of the shaft load to the line of centres"},
          Group{&Result::shaft_1, "shaft_1",
                "maximum shaft load on the driving shaft, in operation or at standstill, for load"}
              .handed_over(),
          Group{&Result::shaft_2, "shaft_2",
                "maximum shaft load on the driven shaft, in operation or at standstill, for load"}
              .handed_over(),
          Field{&Result::f_B, "f_B", Hz, "flex rate of the belt"},
          Field{&Result::N_B, "N_B", ratio, "number of bends to failure"},
          Field{&Result::L_h, "L_h", hour, "belt life"},
          Field{&Result::u_L, "u_L", ratio, "belt life: required / calculated life"}.check("L_req"),
          Field{&Result::u_S, "u_S", ratio, "friction: required / actual initial tension"}.check(),
          Field{&Result::u_Sr, "u_Sr", ratio, "friction, reversed rotation: required / actual initial tension"}
              .check()
              .where_it_applies(),
          Field{&Result::u_sigma, "u_sigma", ratio, "strength: maximum / allowable stress"}.check(),
          Field{&Result::sigma_N, "sigma_N", MPa,
                "stress available for the effective pull, without bending and centrifugal stress"}
              .limit(0, 1e6)
              .criterion(),
          Field{&Result::u_b, "u_b", ratio, "bending at the smaller pulley: bending stress / allowable stress"}.check(
              "E_b"),
          Field{&Result::g_x, "g_x", mm, "clearance between the pulleys, two belt thicknesses deducted"}
              .limit(0, 1e6)
              .criterion(),
          Field{&Result::x_a, "x_a", ratio, "crossed belt: 20 x belt width / centre distance (spans rub above 1)"}
              .limit(0, 1 + 1e-9)
              .where_it_applies(),
          Field{&Result::x_q, "x_q", ratio, "quarter-turn belt: twice the sum of the diameters / centre distance"}
              .limit(0, 1 + 1e-9)
              .where_it_applies(),
          Field{&Result::x_t, "x_t", ratio, "quarter-turn belt: 8 x belt width / centre distance"}
              .limit(0, 1 + 1e-9)
              .where_it_applies(),
          Field{&Result::x_b, "x_b", ratio, "belt width / diameter of the smaller pulley (limit set by loadpath)"}
              .limit(0, 1.5),
          Field{&Result::v_range, "v_range", m_per_s, "belt speed (range of flat belts)"}.limit(5, 100).sizeless(),
          Field{&Result::x_v, "x_v", ratio, "belt speed / maximum speed of the type: 30 m/s, synthetic 100 m/s"}
              .limit(0, 1)
              .sizeless()});

  static bool on_pivot(const Input& in) { return in.tensioning == Tensioning::pivoted_base; }
  static bool clear_of_each_other(const Input& in);
  static FieldFault touching(const Input& in);
  static bool is_thin(const Input& in);
  static constexpr auto rules = join(
      driven_rules<Input>(),
      std::array{
          Rule<Input>{[](const Input& in) { return is_set(in.P) != is_set(in.T_1); }, "P, T_1", "give either P or T_1"},
          Rule<Input>{[](const Input& in) { return is_set(in.a) != is_set(in.L); }, "a, L",
                      "give either the centre distance a or the belt length L"},
          Rule<Input>{
              [](const Input& in) { return !on_pivot(in) || (is_set(in.m_m) && is_set(in.a_G) && is_set(in.h_P)); },
              "tensioning, m_m, a_G, h_P", "a pivoted base needs its mass m_m and the distances a_G and h_P"},
          Rule<Input>{
              [](const Input& in) { return on_pivot(in) || !(is_set(in.m_m) || is_set(in.a_G) || is_set(in.h_P)); },
              "m_m, a_G, h_P, tensioning", "m_m, a_G and h_P belong to a pivoted base: tensioning = \"pivoted_base\""},
          Rule<Input>{[](const Input& in) { return on_pivot(in) || (in.rotation == Rotation::one && !is_set(in.x_P)); },
                      "rotation, x_P, tensioning",
                      "rotation and x_P belong to a pivoted base: tensioning = \"pivoted_base\""},
          Rule<Input>{[](const Input& in) { return !on_pivot(in) || !is_set(in.S_0); }, "S_0, m_m, tensioning",
                      "the initial tension follows from the mass of a pivoted base: leave out S_0"},
          Rule<Input>{[](const Input& in) { return !on_pivot(in) || in.arrangement != Arrangement::quarter_turn; },
                      "tensioning, arrangement", "a pivoted base tensions the belt of parallel shafts only"},
          Rule<Input>{[](const Input& in) { return !is_set(in.h_P) || abs(in.h_P) > 0.0 * m.one; }, "h_P",
                      "a pivot on the line of centres does not tension the belt: give a distance"},
          Rule<Input>{&clear_of_each_other, "a, L, d_1, d_2", "the pulleys must not overlap", &touching},
          Rule<Input>{&is_thin, "delta, d_1, d_2, n_2_set, i_set",
                      "the belt must be thinner than half of the smaller pulley"},
          Rule<Input>{[](const Input& in) { return is_set(in.sigma_f) == is_set(in.m_f); }, "sigma_f, m_f",
                      "the belt life needs both the fatigue strength sigma_f and the exponent m_f"},
          Rule<Input>{[](const Input& in) { return !is_set(in.sigma_f) || is_set(in.E_b); }, "sigma_f, E_b",
                      "the belt life needs the bending modulus E_b, for the stress at the smaller pulley"},
          Rule<Input>{[](const Input& in) { return !is_set(in.L_req) || is_set(in.sigma_f); }, "L_req, sigma_f, m_f",
                      "a required life L_req needs the S-N curve of the belt: sigma_f and m_f"}});

  static constexpr bool turns = true;
  static Applies crossed(const Input& in) { return where(in.arrangement == Arrangement::crossed); }
  static Applies reverses(const Input& in) { return where(on_pivot(in) && in.rotation == Rotation::both); }
  static Applies twisted(const Input& in) { return where(in.arrangement == Arrangement::quarter_turn); }
  static Applies reversible(const Input& in) {
    return in.arrangement == Arrangement::quarter_turn ? Applies::unseen : Applies::no;
  }
  /// Only a belt with an S-N curve has a life, which a required one decides.
  static Applies has_life(const Input& in) { return shown_by(is_set(in.sigma_f)); }
  static double most_fatigue_strength(const Input& in);
  static constexpr std::array bounds{Bound<Input>{"sigma_f", "twice sigma_adm at 1e7 bends", &most_fatigue_strength}};
  static constexpr std::array meanings{Meaning{"P", "mean"}};

  static constexpr std::array modes{
      Mode<Input>{"grip", "belt slip", &always<Input>}.judged_by("u_S"),
      Mode<Input>{"grip_reversed", "belt slip, reversed rotation", &reverses}.judged_by("u_Sr"),
      Mode<Input>{"strength", "tensile strength, tight span", &always<Input>}.judged_by("u_sigma, sigma_N"),
      Mode<Input>{"bending", "bending at the smaller pulley", &always<Input>}.judged_by("u_b"),
      Mode<Input>{"width", "belt width within the pulleys", &always<Input>}.judged_by("x_b").of_shape(),
      Mode<Input>{"speed", "belt speed range", &always<Input>}.judged_by("v_range, x_v"),
      Mode<Input>{"room", "clearance between the pulleys", &always<Input>}.judged_by("g_x").of_shape(),
      Mode<Input>{"twist", "twisting and rubbing of crossed spans", &crossed}.judged_by("x_a"),
      Mode<Input>{"delivery", "delivery angle and twist of a quarter-turn belt", &twisted}
          .judged_by("x_q, x_t")
          .of_shape(),
      Mode<Input>{"reversal", "belt run-off at reversed rotation, quarter-turn belt", &reversible}.special(),
      Mode<Input>{"fatigue", "belt fatigue life (flex rate)", &has_life}.judged_by("u_L").special(),
      Mode<Input>{"rim", "bursting of pulley rims", &unseen<Input>}.special(),
      Mode<Input>{"radial_load", "radial load on the motor shaft", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Arrangement) {
  return std::array{
      ChoiceName<Arrangement>{Arrangement::open, "open", "open: same direction of rotation"},
      ChoiceName<Arrangement>{Arrangement::crossed, "crossed", "crossed: opposite directions of rotation"},
      ChoiceName<Arrangement>{Arrangement::quarter_turn, "quarter_turn",
                              "quarter-turn: shafts at right angles, one direction of rotation"}};
}
constexpr auto choices_of(Flat::Kind) {
  return std::array{ChoiceName<Flat::Kind>{Flat::Kind::conventional, "conventional", "leather, rubber: to 30 m/s"},
                    ChoiceName<Flat::Kind>{Flat::Kind::synthetic, "synthetic", "synthetic: to 100 m/s"}};
}
constexpr auto choices_of(Flat::Tensioning) {
  return std::array{
      ChoiceName<Flat::Tensioning>{Flat::Tensioning::fixed, "fixed", "centres that are fixed when running"},
      ChoiceName<Flat::Tensioning>{Flat::Tensioning::constant_force, "constant_force",
                                   "weight or spring that tensions the pulleys with constant force"},
      ChoiceName<Flat::Tensioning>{Flat::Tensioning::pivoted_base, "pivoted_base",
                                   "motor on a pivoted base, tensioned by its weight and reaction torque"}};
}
constexpr auto choices_of(Flat::Rotation) {
  return std::array{ChoiceName<Flat::Rotation>{Flat::Rotation::one, "one", "one direction"},
                    ChoiceName<Flat::Rotation>{Flat::Rotation::both, "both", "both directions, at the same power"}};
}

}  // namespace loadpath::belt
