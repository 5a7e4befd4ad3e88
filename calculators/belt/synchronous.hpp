// A synchronous belt drive of two pulleys: geometry by teeth, power rating, tensions, shaft loads.
//
// Decides whether a belt of a given width transmits the power, by the rating of ISO 5295: the allowable pull of the
// base width, reduced where fewer than six teeth of the smaller pulley are in mesh, with the width to the power of
// 1.14, less the centrifugal tension. Length and centre distance follow from each other, exactly for circles of the
// pitch diameters. The tensions are those of the customary tension factor. Not covered: curvilinear profiles (HTD,
// AT), idlers (belt.course), more than two pulleys, stocked belt lengths, life of the tension cord. The linked shaft
// load is the larger resultant, in operation or at standstill.
#pragma once

#include "calculators/belt/geometry.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::belt {

struct Synchronous {
  static constexpr auto id = "belt.synchronous";
  static constexpr auto title = "Synchronous belt drive";
  static constexpr auto scope =
      "Number of belt teeth or centre distance, teeth in mesh, power rating by ISO 5295, tensions and shaft loads of a "
      "two-pulley drive with a synchronous belt of trapezoidal profile (XL to XXH); curvilinear profiles, idlers and "
      "belt life are not covered.";
  static constexpr auto source = "[B40], [Inventor-belts], [ISO5295], [RMA-IP24], [Tsubaki-belts]";
  static constexpr auto headline = "z {z_1}/{z_2}, b {b}";
  static constexpr auto details = "{z_B} belt teeth, a = {a}, belt speed v = {v}, shaft load R = {R}";
  static constexpr auto synonyms =
      "synchronous belt, timing belt, toothed belt, cog belt, XL, L, H, XH, XXH, ISO 5295, ISO 5296, teeth in mesh, "
      "Zahnriemen, "
      "Synchronriemen, belt, Riemen, зубчатый ремень, зубчатоременная передача";
  static constexpr bool takes_series = false;  // one thing for all loads
  static constexpr auto example = R"([project]
title = "Pump drive with a synchronous belt"

[pump_belt]
calculator = "belt.synchronous"
synchronous_belt = "H"
P = "4 kW"
K_A = 1.5
n_1 = "1450 rpm"
z_1 = 20
z_2 = 40
a = "500 mm"
b = "50.8 mm"
)";

  struct Input {
    Power P = unset<Power>;
    Moment T_1 = unset<Moment>;
    double K_A = 1.0;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Whole z_1 = 0, z_2 = 0;
    Length p_b = unset<Length>;
    Length a = unset<Length>;
    Whole z_B = 0;
    Length b = unset<Length>, b_0 = unset<Length>;
    Force F_a = unset<Force>;
    LineDensity m_0 = unset<LineDensity>;
    double k_1 = 1.25;
    Speed v_max = unset<Speed>;
    AngularSpeed n_max = unset<AngularSpeed>;
    double z_900 = unset<double>, z_1200 = unset<double>, z_1800 = unset<double>, z_3600 = unset<double>;
  };
  static constexpr Fields inputs{
      Field{&Input::P, "P", kW, "power at the driving pulley, mean over the cycle"}
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
          .usually(1, 2.5)
          .factor(),
      Field{&Input::n_1, "n_1", rpm, "speed of the driving pulley"}
          .positive()
          .near_that_of_source("shafts[#].n")
          .usually(10, 1e4),
      Count{&Input::z_1, "z_1", 6, 200, "number of teeth, driving pulley"}.same_as_that_of_source("stages[#].z_1"),
      Count{&Input::z_2, "z_2", 6, 200, "number of teeth, driven pulley"}.same_as_that_of_source("stages[#].z_2"),
      Field{&Input::p_b, "p_b", mm, "belt pitch"}.positive().usually(2, 40).from("synchronous_belt", "p_b"),
      Field{&Input::a, "a", mm, "required centre distance, adjusted to the number of belt teeth"}
          .positive()
          .usually(20, 2e4)
          .may_be_missing(),
      Count{&Input::z_B, "z_B", 0, 5000, "number of belt teeth, replaces a; 0: the number nearest to a"}
          .may_be_missing(),
      Field{&Input::b, "b", mm, "belt width"}
          .positive()
          .usually(3, 300)
          .searched("synchronous_widths")
          .may_be_missing(),
      Field{&Input::b_0, "b_0", mm, "base width, for which F_a and m_0 are stated"}.positive().usually(3, 300).from(
          "synchronous_belt", "b_0"),
      Field{&Input::F_a, "F_a", N, "allowable effective pull of a belt of the base width"}
          .positive()
          .usually(10, 2e4)
          .from("synchronous_belt", "F_a"),
      Field{&Input::m_0, "m_0", kg_per_m, "mass per length of a belt of the base width"}
          .positive()
          .usually(0.002, 10)
          .from("synchronous_belt", "m_0"),
      Field{&Input::k_1, "k_1", ratio,
            "tension factor: tight side tension / effective pull, without centrifugal tension (1.1 to 1.3)"}
          .within(1.1, 3)
          .usually(1.1, 1.5),
      Field{&Input::v_max, "v_max", m_per_s, "maximum belt speed"}.positive().usually(10, 80).from("synchronous_belt",
                                                                                                   "v_max"),
      Field{&Input::n_max, "n_max", rpm, "maximum speed of the smaller pulley for which minimum teeth are stated"}
          .positive()
          .from("synchronous_belt", "n_max"),
      Field{&Input::z_900, "z_900", ratio, "minimum number of pulley teeth up to 900 rpm"}.positive().from(
          "synchronous_belt", "z_900"),
      Field{&Input::z_1200, "z_1200", ratio, "minimum number of pulley teeth up to 1200 rpm"}.positive().from(
          "synchronous_belt", "z_1200"),
      Field{&Input::z_1800, "z_1800", ratio, "minimum number of pulley teeth up to 1800 rpm"}.positive().from(
          "synchronous_belt", "z_1800"),
      Field{&Input::z_3600, "z_3600", ratio, "minimum number of pulley teeth above 1800 rpm"}.positive().from(
          "synchronous_belt", "z_3600")};

  struct Result {
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>, n_k = unset<AngularSpeed>;
    Length d_1 = unset<Length>, d_2 = unset<Length>;
    Speed v = unset<Speed>;
    double z_0 = unset<double>, z_B = unset<double>;
    Length L = unset<Length>, a = unset<Length>, l_s = unset<Length>;
    double gamma = unset<double>, alpha_1 = unset<double>, alpha_2 = unset<double>;
    double z_m = unset<double>, z_min = unset<double>;
    double c_i = unset<double>, K_B = unset<double>;
    Power P_B = unset<Power>, P_R = unset<Power>;
    double k_z = unset<double>, k_w = unset<double>;
    Force F_t = unset<Force>, F_c = unset<Force>, S_1 = unset<Force>, S_2 = unset<Force>, F_0 = unset<Force>;
    Force R_0 = unset<Force>, R_x = unset<Force>, R_y = unset<Force>, R = unset<Force>;
    double theta_R = unset<double>;
    ShaftLoad shaft_1, shaft_2;
    AngularSpeed f_B = unset<AngularSpeed>;
    double u_P = unset<double>;
    double x_m = unset<double>, x_z = unset<double>, x_v = unset<double>, x_n = unset<double>, x_b = unset<double>;
    Length b_s = unset<Length>;
    double x_w = unset<double>;
    Length g_x = unset<Length>, g_f = unset<Length>;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "speed ratio n_1/n_2, exact"},
      Field{&Result::n_2, "n_2", rpm, "speed of the driven pulley"},
      Field{&Result::n_k, "n_k", rpm, "speed of the smaller pulley"},
      Field{&Result::d_1, "d_1", mm, "pitch diameter, driving pulley"}.at_least_that_of_source("d"),
      Field{&Result::d_2, "d_2", mm, "pitch diameter, driven pulley"},
      Field{&Result::v, "v", m_per_s, "belt speed"},
      Field{&Result::z_0, "z_0", ratio, "number of belt teeth for the required centre distance, not rounded"},
      Field{&Result::z_B, "z_B", ratio, "number of belt teeth"},
      Field{&Result::L, "L", mm, "pitch length of the belt"},
      Field{&Result::a, "a", mm, "centre distance for this number of belt teeth"},
      Field{&Result::l_s, "l_s", mm, "free span length"},
      Field{&Result::gamma, "gamma", deg, "span angle to the line of centres"},
      Field{&Result::alpha_1, "alpha_1", deg, "wrap angle, driving pulley"},
      Field{&Result::alpha_2, "alpha_2", deg, "wrap angle, driven pulley"},
      Field{&Result::z_m, "z_m", ratio, "teeth in mesh, smaller pulley"},
      Field{&Result::z_min, "z_min", ratio, "minimum number of teeth of the smaller pulley at its speed"},
      Field{&Result::c_i, "c_i", ratio, "addition to the service factor for a speed-up drive"},
      Field{&Result::K_B, "K_B", ratio, "total service factor"},
      Field{&Result::P_B, "P_B", kW, "design power"}.holding("K_A"),
      Field{&Result::k_z, "k_z", ratio, "teeth-in-mesh factor"},
      Field{&Result::k_w, "k_w", ratio, "width factor"},
      Field{&Result::P_R, "P_R", kW, "power rating of the belt"}.limit(1e-9, 1e9).criterion(),
      Field{&Result::F_t, "F_t", N, "effective pull (circumferential force), with the total service factor"}.holding(
          "K_A"),
      Field{&Result::F_c, "F_c", N, "centrifugal tension"},
      Field{&Result::S_1, "S_1", N, "tight side tension"},
      Field{&Result::S_2, "S_2", N, "slack side tension"},
      Field{&Result::F_0, "F_0", N, "initial tension of a span at standstill, for the tension factor"},
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
      Field{&Result::u_P, "u_P", ratio, "rating: design power / power rating of the belt"}.check(),
      Field{&Result::x_m, "x_m", ratio, "teeth in mesh, smaller pulley (rated from 2; 6 for the full rating)"}.limit(
          2, 1e9),
      Field{&Result::x_z, "x_z", ratio, "minimum / actual number of teeth of the smaller pulley"}
          .limit(0, 1, "z_900, z_1200, z_1800, z_3600")
          .criterion()
          .where_it_applies(),
      Field{&Result::x_v, "x_v", ratio, "belt speed / maximum belt speed"}.limit(0, 1, "v_max").sizeless(),
      Field{&Result::x_n, "x_n", ratio, "speed of the smaller pulley / maximum speed with stated minimum teeth"}
          .limit(0, 1, "n_max")
          .sizeless(),
      Field{&Result::x_b, "x_b", ratio, "belt width / base width (the widest rated belt)"}.limit(0, 1 + 1e-9),
      Field{&Result::b_s, "b_s", mm, "smallest standard width of the section"},
      Field{&Result::x_w, "x_w", ratio, "smallest standard width of the section / belt width"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Result::g_x, "g_x", mm, "clearance between the pitch circles of the pulleys"},
      Field{&Result::g_f, "g_f", mm, "clearance between the flanges of the pulleys"}
          .limit(0, 1e6)
          .criterion()
          .sizeless()};

  static bool pulleys_apart(const Input& in);
  static FieldFault pulleys_touch(const Input& in);
  static bool belt_reaches(const Input& in);
  static FieldFault too_few_teeth(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.P) != is_set(in.T_1); }, "P, T_1", "give either P or T_1"},
      Rule<Input>{[](const Input& in) { return is_set(in.p_b); }, "p_b",
                  "give the pitch p_b, or a belt: synchronous_belt = \"H\""},
      Rule<Input>{[](const Input& in) { return is_set(in.b_0) && is_set(in.F_a) && is_set(in.m_0); }, "b_0, F_a, m_0",
                  "give b_0, F_a and m_0 of the belt, or a belt: synchronous_belt = \"H\""},
      Rule<Input>{[](const Input& in) { return is_set(in.a) != (in.z_B > 0); }, "a, z_B",
                  "give either the centre distance a or the number of belt teeth z_B"},
      Rule<Input>{&pulleys_apart, "a, p_b, z_1, z_2", "the pulleys must not overlap", &pulleys_touch},
      Rule<Input>{&belt_reaches, "z_B, z_1, z_2", "the belt must reach around both pulleys", &too_few_teeth}};

  static double most_width(const Input& in);
  static double standard_width(const Input& in);
  static double most_pull(const Input& in);
  static double trapezoidal_pitch(const Input& in);
  static double least_centre_distance(const Input& in);
  static double least_belt_teeth(const Input& in);
  static constexpr std::array bounds{
      Bound<Input>{"b", "the smaller pitch diameter", &most_width},
      Bound<Input>{"b", "the next smaller standard width", &standard_width},
      Bound<Input>{"F_a", "5 N/mm^2 of pitch x base width", &most_pull},
      Bound<Input>{"p_b", "the next trapezoidal profile (3, 8, 14 mm: curvilinear)", &trapezoidal_pitch},
      Bound<Input>{"a", "a wrap of 120°", &least_centre_distance}.least(),
      Bound<Input>{"z_B", "a wrap of 120°", &least_belt_teeth}.least(),
      Bound<Input>{"z_1", "a speed ratio of 7", [](const Input& in) { return 7.0 * in.z_2; }},
      Bound<Input>{"z_2", "a speed ratio of 7", [](const Input& in) { return 7.0 * in.z_1; }}};

  static constexpr bool turns = true;
  static constexpr std::array meanings{Meaning{"P", "mean"}};
  static constexpr std::array modes{
      Mode<Input>{"power", "power rating of the belt", &always<Input>}.judged_by("u_P, P_R"),
      Mode<Input>{"mesh", "teeth in mesh, smaller pulley", &always<Input>}.judged_by("x_m").of_shape(),
      Mode<Input>{"pulley", "minimum number of pulley teeth", &always<Input>}.judged_by("x_z, x_n"),
      Mode<Input>{"speed", "maximum belt speed", &always<Input>}.judged_by("x_v").wanting("v_max"),
      Mode<Input>{"width", "belt width within the rated widths", &always<Input>}.judged_by("x_b, x_w").of_shape(),
      Mode<Input>{"room", "clearance between the pulleys", &always<Input>}.judged_by("g_f").of_shape(),
      Mode<Input>{"ratcheting", "tooth jump under peak torque", &unseen<Input>}.special(),
      Mode<Input>{"fatigue", "fatigue life of the tension cord", &unseen<Input>}.special(),
      Mode<Input>{"radial_load", "radial load on the motor shaft", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::belt
