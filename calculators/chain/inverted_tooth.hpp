// A drive with an inverted-tooth (silent) chain: geometry, width by the manufacturer's rating, breakage, shaft loads.
//
// Such a chain is selected by its width: the design power, nominal power times service factor, over the rated power of
// a chain of unit width at the speed and number of teeth of the smaller sprocket, which is a table of the manufacturer
// and an input here. An odd number of links needs a hunting link, and a chain wider by a quarter [Ramsey]. Links and
// centre distance are exact for a chain that lies on circles of z p/(2 pi), as for roller chains; the rocker joints
// reduce the chordal action, which is left out. K_A acts once. Breakage is assessed with the mass of the chain only:
// its centrifugal force and sag are part of the pull. Not covered: service life, idlers, duplex chains.
#pragma once

#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <vector>

namespace loadpath::chain {

struct InvertedTooth {
  static constexpr auto id = "chain.inverted_tooth";
  static constexpr auto title = "Inverted-tooth (silent) chain drive";
  static constexpr auto scope =
      "Chain length, centre distance, required width by the manufacturer's rating, chain pull, static safety factor "
      "against breakage and shaft loads of a two-sprocket drive with an inverted-tooth (silent) chain; "
      "service life is not covered.";
  static constexpr auto source = "[Ramsey], [ISO10823], [Vunivere]";
  static constexpr auto headline = "z {z_1}/{z_2}, b {b}";
  static constexpr auto details = "{X} links, a = {a}, chain speed v = {v}, shaft load F_W = {F_W}";
  static constexpr auto synonyms =
      "inverted tooth chain, inverted-tooth chain, silent chain, toothed chain, ANSI B29.2M, DIN 8190, Zahnkette, "
      "Zahnkettentrieb, chain, Kette, зубчатая цепь, бесшумная цепь";
  static constexpr auto example = R"([project]
title = "Silent chain of a blower"

[blower]
calculator = "chain.inverted_tooth"
p = "12.7 mm"
b = "50 mm"
z_1 = 25
z_2 = 75
n_1 = "1000 rpm"
P = "15 kW"
K_A = 1.4
a = "500 mm"
P_b = "5 kW"
q = "2.5 kg/m"
F_u = "54 kN"
S_min = 8
v_max = "25 m/s"
)";

  struct Input {
    Length p = unset<Length>, b = unset<Length>;
    Whole z_1 = 0, z_2 = 0;
    Length a = unset<Length>;
    Whole X = 0;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Power P = unset<Power>;
    double K_A = 1.0, K_f = 6.0;
    Power P_b = unset<Power>;
    Length b_R = 10.0 * mm.one;
    LineDensity q = unset<LineDensity>;
    Force F_u = unset<Force>;
    double S_min = unset<double>;
    Speed v_max = unset<Speed>;
  };
  static bool sprockets_apart(const Input& in);
  static FieldFault sprockets_touch(const Input& in);
  static bool links_reach(const Input& in);
  static FieldFault too_few_links(const Input& in);
  static Applies limited_speed(const Input& in) { return where(is_set(in.v_max)); }
  static constexpr Fields inputs{
      Field{&Input::p, "p", mm, "pitch of the chain"}.positive().usually(4, 60).same_as_that_of_source("stages[#].p"),
      Field{&Input::b, "b", mm, "chain width"}.positive().usually(5, 1000).findable("R20"),
      Count{&Input::z_1, "z_1", 12, 150, "number of teeth, driving sprocket"}.same_as_that_of_source("stages[#].z_1"),
      Count{&Input::z_2, "z_2", 12, 150, "number of teeth, driven sprocket"}.same_as_that_of_source("stages[#].z_2"),
      Field{&Input::a, "a", mm, "required centre distance, adjusted to the number of links"}
          .positive()
          .may_be_missing(),
      Count{&Input::X, "X", 0, 2000, "number of links, replaces a; 0: the even number nearest to a"}.may_be_missing(),
      Field{&Input::n_1, "n_1", rpm, "speed of the driving sprocket"}.positive().near_that_of_source("shafts[#].n"),
      Field{&Input::P, "P", kW, "nominal power"}.load().at_least(0).at_least_that_of_source("shafts[#].P"),
      Field{&Input::K_A, "K_A", ratio,
            "service factor for the driver and the driven machine (1 if the load includes it)"}
          .at_least(1)
          .usually(1, 2.5)
          .factor(),
      Field{&Input::K_f, "K_f", ratio, "sag factor: 6 for a horizontal drive, 3 at 40°, 1 for a vertical drive"}
          .within(0, 10)
          .usually(1, 6),
      Field{&Input::P_b, "P_b", kW, "rated power of the width b_R, by the manufacturer"}.positive().may_be_missing(),
      Field{&Input::b_R, "b_R", mm, "width of the rating; 25.4 mm: power per inch of width"}.positive().usually(1, 100),
      Field{&Input::q, "q", kg_per_m, "mass per length of the chain"}.positive().usually(0.1, 200).may_be_missing(),
      Field{&Input::F_u, "F_u", kN, "breaking load of the chain"}.positive().usually(1, 5000).may_be_missing(),
      Field{&Input::S_min, "S_min", ratio, "required safety factor against breakage"}
          .at_least(1)
          .usually(5, 20)
          .customarily_at_least(5)
          .may_be_missing(),
      Field{&Input::v_max, "v_max", m_per_s, "maximum chain speed (manufacturer)"}.positive().may_be_missing()};

  struct Result {
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Length d_1 = unset<Length>, d_2 = unset<Length>;
    double X_0 = unset<double>, X = unset<double>, odd = unset<double>;
    Length a = unset<Length>, L = unset<Length>;
    double a_p = unset<double>;
    double alpha_1 = unset<double>, alpha_2 = unset<double>;
    Speed v = unset<Speed>;
    double v_share = unset<double>;
    Moment T_1 = unset<Moment>, T_2 = unset<Moment>;
    Force F_t = unset<Force>, F_c = unset<Force>, F_f = unset<Force>, F = unset<Force>, F_W = unset<Force>;
    ShaftLoad shaft_1, shaft_2;
    Power P_c = unset<Power>;
    Length b_min = unset<Length>;
    double S_dyn = unset<double>;
    double u_b = unset<double>, u_F = unset<double>, u_S = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "speed ratio n_1/n_2 (up to 7, at most 10)"}.limit(0.1, 10),
      Field{&Result::n_2, "n_2", rpm, "mean speed of the driven sprocket"},
      Field{&Result::d_1, "d_1", mm, "pitch diameter, driving sprocket"},
      Field{&Result::d_2, "d_2", mm, "pitch diameter, driven sprocket"},
      Field{&Result::X_0, "X_0", ratio, "number of links for the required centre distance, not rounded"},
      Field{&Result::X, "X", ratio, "number of links"},
      Field{&Result::odd, "odd", ratio, "odd number of links (hunting link required); 0: even"},
      Field{&Result::a, "a", mm, "centre distance of the taut chain"},
      Field{&Result::a_p, "a_p", ratio, "centre distance in pitches"},
      Field{&Result::L, "L", mm, "chain length"},
      Field{&Result::alpha_1, "alpha_1", deg, "wrap angle, driving sprocket (at least 120°)"}.limit(120, 360),
      Field{&Result::alpha_2, "alpha_2", deg, "wrap angle, driven sprocket (at least 120°)"}.limit(120, 360),
      Field{&Result::v, "v", m_per_s, "mean chain speed"},
      Field{&Result::v_share, "v_share", ratio, "chain speed / maximum speed"}.limit(0, 1, "v_max"),
      Field{&Result::T_1, "T_1", N_m, "torque of the driving sprocket, nominal"}.load().with("F_W"),
      Field{&Result::T_2, "T_2", N_m, "torque of the driven sprocket, nominal, without losses"}.load().with("F_W"),
      Field{&Result::F_t, "F_t", N, "chain pull, nominal"},
      Field{&Result::F_c, "F_c", N, "centrifugal force"},
      Field{&Result::F_f, "F_f", N, "chain pull due to sag"},
      Field{&Result::F, "F", N, "maximum chain pull: with service factor, centrifugal force and sag"}.holding("K_A"),
      Field{&Result::F_W, "F_W", N, "force on each shaft, along the line of centres"}.load().with("T_1|T_2").holding(
          "K_A"),
      Group{&Result::shaft_1, "shaft_1", "shaft load on the driving shaft, for load"}.handed_over(),
      Group{&Result::shaft_2, "shaft_2", "shaft load on the driven shaft, for load"}.handed_over(),
      Field{&Result::P_c, "P_c", kW, "design power, with service factor"},
      Field{&Result::b_min, "b_min", mm, "required chain width"},
      Field{&Result::S_dyn, "S_dyn", ratio, "safety factor against breakage, with service factor"},
      Field{&Result::u_b, "u_b", ratio, "rating: required / actual chain width"}.check("P_b"),
      Field{&Result::u_F, "u_F", ratio, "breakage: maximum pull / breaking load"}.check("F_u").where_it_applies(),
      Field{&Result::u_S, "u_S", ratio,
            "breakage: required / calculated safety factor (not sufficient as the only "
            "design criterion)"}
          .check("S_min")
          .where_it_applies()};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return is_set(in.a) != (in.X > 0); }, "a, X",
                  "give either the centre distance a or the number of links X"},
      Rule<Input>{&sprockets_apart, "a, p, z_1, z_2", "the sprockets touch at this centre distance", &sprockets_touch},
      Rule<Input>{&links_reach, "X, z_1, z_2", "the chain is too short to go around the sprockets", &too_few_links},
      Rule<Input>{[](const Input& in) { return !is_set(in.S_min) || is_set(in.F_u); }, "S_min, F_u",
                  "the safety factor needs the breaking load F_u"},
      Rule<Input>{[](const Input& in) { return in.X % 2 == 0; }, "X",
                  "an odd number of links needs a hunting link and a chain wider by 25 %", nullptr, true}};

  static double most_breaking_load(const Input& in);
  static double most_rating(const Input& in);
  static double most_width(const Input& in);
  static double least_mass(const Input& in);
  static double most_speed(const Input& in);
  static double most_rotation(const Input& in);
  static double most_centre(const Input& in);
  static double most_links(const Input& in);
  static constexpr std::array bounds{Bound<Input>{"F_u", "140 N/mm^2 of pitch x width", &most_breaking_load},
                                     Bound<Input>{"P_b", "a pull of 20 N/mm^2 of pitch x width", &most_rating},
                                     Bound<Input>{"b", "the smaller sprocket diameter", &most_width},
                                     Bound<Input>{"q", "a silent chain of this pitch and width", &least_mass}.least(),
                                     Bound<Input>{"v_max", "silent chains", &most_speed},
                                     Bound<Input>{"n_1", "a chain speed of 35 m/s", &most_rotation},
                                     Bound<Input>{"a", "80 pitches", &most_centre},
                                     Bound<Input>{"X", "80 pitches", &most_links}};

  static constexpr bool turns = true;
  static constexpr std::array modes{
      Mode<Input>{"rating", "link plate fatigue and joint wear (rated power)", &always<Input>}.judged_by("u_b"),
      Mode<Input>{"breaking", "static breaking strength of the chain", &always<Input>}
          .judged_by("u_S, u_F")
          .wanting("q"),
      Mode<Input>{"speed", "maximum chain speed", &limited_speed}.judged_by("v_share"),
      Mode<Input>{"wrap_1", "wrap angle, driving sprocket", &always<Input>}.judged_by("alpha_1").of_shape(),
      Mode<Input>{"wrap_2", "wrap angle, driven sprocket", &always<Input>}.judged_by("alpha_2").of_shape(),
      Mode<Input>{"ratio", "speed ratio per stage", &always<Input>}.judged_by("i").of_shape(),
      Mode<Input>{"sprockets", "sprocket tooth wear", &unseen<Input>}.special(),
      Mode<Input>{"vibration", "strand vibration", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::chain
