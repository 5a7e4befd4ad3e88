// A rolling bearing by its load ratings: rating life, static safety, least load, speed, axial load that its kind takes.
//
// Decides L_10 = (C/P)^p of [ISO281] with the reliability a_1, for one load or for blocks of load and speed, against
// the required life; s_0 = C_0/P_0 of [ISO76]; the minimum load against skidding. C, C_0, the factors and the speed
// are those of the manufacturer's table; deep groove ball bearings have theirs by f_0. For a bearing with one axial
// load direction F_a is positive in that direction and includes the induced axial force, or the mate of the pair is
// given with their arrangement; for others its sign has no effect. K_A acts once: on all loads but those at rest, F_r0
// and F_a0. a_ISO by viscosity ratio, e_C and C_u. Not covered: annex A of e_C, swinging, clearance, tilt, spherical
// thrust bearings.
#pragma once

#include "calculators/bearing/rolling_block.hpp"
#include "calculators/bearing/rolling_bounds.hpp"
#include "calculators/bearing/rolling_centre.hpp"
#include "calculators/bearing/rolling_kind.hpp"
#include "calculators/bearing/rolling_life.hpp"
#include "calculators/bearing/rolling_mate.hpp"
#include "calculators/bearing/rolling_seat.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/row_kind.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace loadpath::bearing {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Rolling {
  static constexpr auto id = "bearing.rolling";
  static constexpr auto title = "Rolling bearing";
  static constexpr auto scope =
      "Rating life with reliability, lubricant and contamination (a_ISO) for one load or blocks of load and speed, "
      "static safety factor, minimum load, speed and axial load limits of a rolling bearing, induced axial forces of "
      "a pair, fit on its shaft seat and shoulder; oscillation and misalignment are not covered.";
  static constexpr auto source = "[ISO281], [ISO281-aISO], [ISO76]";
  static constexpr auto headline = "{bearing}|C = {C}";
  static constexpr auto synonyms =
      "rolling bearing, ball bearing, roller bearing, deep groove ball bearing, angular contact, tapered roller, "
      "basic rating life, L10, ISO 281, ISO 76, static safety, equivalent load, Wälzlager, Kugellager, "
      "Rillenkugellager, Lagerlebensdauer, Lebensdauer, bearing life, L10h, tapered roller bearing, "
      "cylindrical roller bearing, Rollenlager, подшипник качения, шариковый подшипник, долговечность, "
      "динамическая грузоподъёмность, подшипник";
  static constexpr bool takes_series = false;  // one life for all loads
  static constexpr auto example = R"([project]
title = "Bearing 6208 of a gear shaft"

[left]
calculator = "bearing.rolling"
kind = "deep_groove_ball"
C = "29.1 kN"
C_0 = "17.9 kN"
f_0 = 14
F_r = "2.5 kN"
F_a = "1 kN"
n = "900 rpm"
n_max = "8500 rpm"
L_h = "15000 h"
s_0 = 2
)";

  using Block = bearing::Block;
  static constexpr std::size_t most_blocks = 32;

  struct Input {
    Kind kind = Kind::unstated;
    Force C = unset<Force>, C_0 = unset<Force>;
    Force F_r = unset<Force>, F_a = 0.0 * N.one;
    double K_A = 1.0;
    AngularSpeed n = unset<AngularSpeed>, n_max = unset<AngularSpeed>;
    double f_0 = unset<double>, e = unset<double>, X = unset<double>, Y = unset<double>, Y_1 = unset<double>;
    double Y_0 = unset<double>;
    Time L_h = unset<Time>;
    double L_m = unset<double>;
    double a_1 = 1.0, s_0 = unset<double>;
    Force P_min = unset<Force>, F_a_adm = unset<Force>;
    Length d = unset<Length>, D = unset<Length>, B = unset<Length>, r_s = unset<Length>, d_a = unset<Length>;
    Length d_s = unset<Length>, l_s = unset<Length>, r_f = unset<Length>, d_f = unset<Length>;
    Force F_r0 = unset<Force>, F_a0 = unset<Force>;
    List<Block, most_blocks> blocks;
    Holds holds = Holds::unsaid;
    double R = unset<double>, kappa = unset<double>, e_C = unset<double>;
    Viscosity nu = unset<Viscosity>;
    Force C_u = unset<Force>;
    Mate mate;
    Arrangement arrangement = Arrangement::unsaid;
    Carries carries = Carries::unsaid;
    Length x = unset<Length>, a = unset<Length>, s_p = unset<Length>;
    double c_i = 0.5;
  };
  /// A bearing that locates the shaft and lets it slip.
  static Applies locates_nothing(const Input& in) {
    return where(in.holds == Holds::both && takes_radial_alone(in.kind));
  }
  static AngularSpeed highest_speed(const Input& in);
  static bool has_axial(const Input& in);
  static bool factors_given(const Input& in);
  static bool factors_once(const Input& in);
  static bool static_factors_given(const Input& in);
  static bool shares_close(const Input& in);
  static bool ratings_agree(const Input& in);
  static FieldFault odd_ratings(const Input& in);
  static FieldFault missing_factors(const Input& in);
  static FieldFault open_shares(const Input& in);
  static Applies runs(const Input& in);
  static Applies runs_fast(const Input& in);
  static Applies runs_at_an_angle(const Input& in);
  static Applies has_axial_bound(const Input& in);
  static constexpr Fields inputs = join(
      Fields{RecordField<Input>{"load", "loads of a shaft bearing: load = \"=shaft.bearings.left\""},
             RowKind{&Input::kind, "kind", "bearing type", "bearing"},
             Field{&Input::C, "C", kN, "basic dynamic load rating, manufacturer's value"}
                 .positive()
                 .usually(0.05, 1e5)
                 .from("bearing", "C"),
             Field{&Input::C_0, "C_0", kN, "basic static load rating"}
                 .positive()
                 .usually(0.02, 2e5)
                 .from("bearing", "C_0")
                 .where_it_has(),
             Field{&Input::F_r, "F_r", kN, "radial load on the bearing"}.load().at_least(0),
             Field{&Input::F_a, "F_a", kN,
                   "axial load on the bearing; single-direction types: positive in the load-carrying "
                   "direction, induced axial force included"}
                 .load(),
             Field{&Input::K_A, "K_A", ratio, "application factor K_A on F_r and F_a (1 if they include it)"}
                 .at_least(1)
                 .usually(1, 4)
                 .factor(),
             Field{&Input::n, "n", rpm, "relative speed of the rings; 0 at standstill"}
                 .at_least_that_of_source("n, shafts[#].n, joints.#.omega")
                 .at_least(0)
                 .may_be_missing(),
             Field{&Input::n_max, "n_max", rpm, "limiting speed for this lubrication, manufacturer's value"}
                 .positive()
                 .from("bearing", "n_max")
                 .where_it_has(),
             Field{&Input::f_0, "f_0", ratio,
                   "calculation factor f_0 of a deep groove ball bearing for e and Y, manufacturer's value"}
                 .positive()
                 .usually(8, 18)
                 .from("bearing", "f_0")
                 .where_it_has(),
             Field{&Input::e, "e", ratio, "limiting ratio F_a/F_r above which X and Y apply, manufacturer's value"}
                 .within(0.01, 3)
                 .usually(0.1, 2)
                 .from("bearing", "e")
                 .where_it_has(),
             Field{&Input::X, "X", ratio, "radial load factor above e; omitted: that of the type"}
                 .at_least(0)
                 .usually(0.3, 1)
                 .from("bearing", "X")
                 .where_it_has(),
             Field{&Input::Y, "Y", ratio, "axial load factor above e (double-row: Y_2)"}
                 .positive()
                 .usually(0.2, 7)
                 .from("bearing", "Y")
                 .where_it_has(),
             Field{&Input::Y_1, "Y_1", ratio, "axial load factor up to e (double-row)"}
                 .at_least(0)
                 .usually(0.3, 5)
                 .from("bearing", "Y_1")
                 .where_it_has(),
             Field{&Input::Y_0, "Y_0", ratio, "axial factor of the equivalent static load"}
                 .at_least(0)
                 .usually(0.2, 5)
                 .from("bearing", "Y_0")
                 .where_it_has(),
             Field{&Input::L_h, "L_h", hour, "required life"}
                 .at_least(1)
                 .usually(100, 3e5)
                 .customarily_at_least(100)
                 .may_be_missing(),
             Field{&Input::L_m, "L_m", ratio, "required life in millions of revolutions, replaces hours"}
                 .positive()
                 .usually(1, 1e5)
                 .may_be_missing(),
             Field{&Input::a_1, "a_1", ratio,
                   "life modification factor for reliability: 1 for 90 %, 0.64 for 95, 0.55 for 96, 0.47 for "
                   "97, 0.37 for 98, 0.25 for 99 %"}
                 .within(0.01, 1)
                 .factor(),
             Field{&Input::s_0, "s_0", ratio,
                   "required static safety factor: at rest 0.5 (balls) and 1 (rollers), running 1 to 2 and "
                   "1.5 to 3.5, higher under shock loads"}
                 .at_least(0.4)
                 .usually(0.5, 10)
                 .customarily_at_least(0.5)
                 .may_be_missing()
                 .factor(),
             Field{&Input::P_min, "P_min", kN, "minimum load, manufacturer's value; 0.01 C (balls), 0.02 C (rollers)"}
                 .positive()
                 .may_be_missing(),
             Field{&Input::F_a_adm, "F_a_adm", kN,
                   "allowable axial load, manufacturer's value; deep groove ball bearing: 0.5 C_0 (enter 0.25 "
                   "C_0 for a light series)"}
                 .positive()
                 .from("bearing", "F_a_adm")
                 .where_it_has(),
             Field{&Input::F_r0, "F_r0", kN, "peak radial load at rest or under shock, if larger than in operation"}
                 .load()
                 .at_least(0)
                 .may_be_missing(),
             Field{&Input::F_a0, "F_a0", kN, "simultaneous axial load"}.load().may_be_missing(),
             ListField{&Input::blocks, "blocks", "blocks of load and speed with fractions of time; omitted: one block"}
                 .may_be_missing(),
             Choice{&Input::holds, "holds", "loads that the bearing must carry: radial, or radial and axial"}
                 .may_be_missing()},
      life_inputs<Input>(), pair_inputs<Input>(), centre_inputs<Input>(), dimension_inputs<Input>(),
      seat_inputs<Input>());

  struct Stage {
    Name name;
    double q = unset<double>;
    AngularSpeed n = unset<AngularSpeed>;
    double e = unset<double>, Y = unset<double>;
    Force P = unset<Force>;
    double D = unset<double>;
    double kappa = unset<double>, a_ISO = unset<double>;
    static constexpr Fields fields{
        NameField{&Stage::name, "name", "name of the block"},
        Field{&Stage::q, "q", ratio, "fraction of time"},
        Field{&Stage::n, "n", rpm, "speed"},
        Field{&Stage::e, "e", ratio, "limiting ratio F_a/F_r above which the axial load is included"},
        Field{&Stage::Y, "Y", ratio, "axial load factor"},
        Field{&Stage::P, "P", kN, "equivalent dynamic load"}.holding("K_A"),
        Field{&Stage::D, "D", ratio, "share of the fatigue damage"},
        Field{&Stage::kappa, "kappa", ratio, "viscosity ratio"},
        Field{&Stage::a_ISO, "a_ISO", ratio, "life modification factor for lubricant and contamination"}};
  };

  struct Result {
    double p = unset<double>, x_f = unset<double>, e = unset<double>, Y = unset<double>;
    Force P = unset<Force>, P_m = unset<Force>;
    AngularSpeed n_m = unset<AngularSpeed>;
    double L_10 = unset<double>;
    Time L_10h = unset<Time>, L_nh = unset<Time>;
    double a_ISO = unset<double>, R_L = unset<double>, x_k = unset<double>;
    Force C_req = unset<Force>, P_0 = unset<Force>, F_ax = unset<Force>, F_i = unset<Force>, F_ao = unset<Force>,
          F_ro = unset<Force>;
    double u_L = unset<double>, x_P = unset<double>, u_0 = unset<double>, x_min = unset<double>, u_n = unset<double>;
    double u_a = unset<double>, x_i = unset<double>;
    Length s_c = unset<Length>;
    double x_c = unset<double>;
    double x_d = unset<double>, x_B = unset<double>, x_r = unset<double>, x_a = unset<double>;
    List<Stage, most_blocks> blocks;
  };
  static constexpr Fields results = join(
      Fields{
          Field{&Result::p, "p", ratio, "life exponent: 3 (balls), 10/3 (rollers)"},
          Field{&Result::x_f, "x_f", ratio, "f_0 F_a/C_0 (range of the table of e and Y)"}
              .limit(0, 6.89 * (1.0 + 1e-9), "f_0")
              .where_it_applies(),
          Field{&Result::e, "e", ratio, "limiting ratio F_a/F_r above which the axial load is included"}.as_given(),
          Field{&Result::Y, "Y", ratio, "axial load factor above e"}.as_given(),
          Field{&Result::P, "P", kN, "equivalent dynamic load of F_r and F_a"}.holding("K_A"),
          Field{&Result::P_m, "P_m", kN, "equivalent dynamic load of all blocks"}.holding("K_A"),
          Field{&Result::n_m, "n_m", rpm, "mean speed"},
          Field{&Result::L_10, "L_10", ratio, "basic rating life in millions of revolutions, 90 %"},
          Field{&Result::L_10h, "L_10h", hour, "basic rating life, 90 %"},
          Field{&Result::L_nh, "L_nh", hour, "life with the required reliability, and with a_ISO where given"},
          Field{&Result::a_ISO, "a_ISO", ratio, "life modification factor for lubricant and contamination"},
          Field{&Result::R_L, "R_L", ratio, "reliability of the required life"},
          Field{&Result::x_k, "x_k", ratio, "smallest viscosity ratio in operation (a_ISO from 0.1 on)"}
              .limit(least_kappa, unbounded, "nu")
              .where_it_applies(),
          Field{&Result::C_req, "C_req", kN, "required dynamic load rating"}.holding("K_A"),
          Field{&Result::P_0, "P_0", kN, "equivalent static load, maximum"}.holding("K_A"),
          Field{&Result::F_ax, "F_ax", kN, "axial load in the direction that the bearing carries, without K_A"},
          Field{&Result::F_i, "F_i", kN, "induced axial force on the mating bearing: c_i F_r/Y"}.load().holding("K_A"),
          Field{&Result::F_ao, "F_ao", N, "axial load not carried by the bearing type"}.limit(0, 1e-3).criterion(),
          Field{&Result::F_ro, "F_ro", N, "radial load not carried by the bearing type"}.limit(0, 1e-3).criterion(),
          Field{&Result::u_L, "u_L", ratio, "rating life: required dynamic load rating / C"}
              .check("L_h, L_m")
              .where_it_applies(),
          Field{&Result::x_P, "x_P", ratio, "maximum P / min(C/2, C_0) (validity of the rating life)"}
              .limit(0, 1)
              .where_it_applies(),
          Field{&Result::u_0, "u_0", ratio, "static: s_0 x P_0 / C_0"}.check("s_0"),
          Field{&Result::x_min, "x_min", ratio, "minimum P in operation / minimum load (skidding below 1)"}
              .limit(1 - 1e-9, unbounded)
              .criterion()
              .where_it_applies(),
          Field{&Result::u_n, "u_n", ratio, "maximum speed / limiting speed"}.check("n_max").where_it_applies(),
          Field{&Result::u_a, "u_a", ratio, "axial load / allowable axial load"}
              .check("F_a_adm, C_0")
              .where_it_applies(),
          Field{&Result::x_i, "x_i", ratio, "axial load / induced axial force F_i"}
              .limit(1 - 1e-6, unbounded)
              .where_it_applies(),
          ListField{&Result::blocks, "blocks", "the blocks"}},
      centre_results<Result>(), seat_results<Result>());

  static constexpr auto rules = join(
      std::array{
          Rule<Input>{[](const Input& in) { return in.kind != Kind::unstated; }, "kind",
                      "give the bearing type, kind, or a row of the tables: bearing = \"6208\""},
          Rule<Input>{&ratings_agree, "C, C_0", "C and C_0 must belong to the same bearing", &odd_ratings},
          Rule<Input>{&factors_once, "f_0, e, Y", "give either f_0 (deep groove ball bearing) or e and Y"},
          Rule<Input>{&factors_given, "e, Y, X, Y_1, f_0, C_0, F_a, kind", "this load needs the factors of the bearing",
                      &missing_factors},
          Rule<Input>{[](const Input& in) { return !is_set(in.s_0) || is_set(in.C_0); }, "s_0, C_0",
                      "the static safety factor needs the static load rating C_0"},
          Rule<Input>{&static_factors_given, "Y_0, s_0, F_a, F_a0, kind",
                      "the static safety factor under an axial load needs Y_0 of the manufacturer"},
          Rule<Input>{[](const Input& in) { return !is_set(in.F_a0) || is_set(in.F_r0); }, "F_a0, F_r0",
                      "give the radial load F_r0 with F_a0, even if it is zero"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.L_h) && is_set(in.L_m)); }, "L_h, L_m",
                      "give the life either in hours or in revolutions"},
          Rule<Input>{[](const Input& in) {
                        return in.blocks.empty() || is_set(in.n) ||
                               std::all_of(in.blocks.begin(), in.blocks.end(),
                                           [](const Block& b) { return is_set(b.n); });
                      },
                      "n, blocks", "every block needs a speed: its own n, or that of the bearing"},
          Rule<Input>{[](const Input& in) { return !is_set(in.L_m) || !is_set(in.n) || in.n > 0.0 * rpm; }, "L_m, n",
                      "a bearing at standstill has no life in revolutions: omit L_m or n"},
          Rule<Input>{[](const Input& in) { return !is_set(in.L_h) || highest_speed(in) > 0.0 * rpm; },
                      "L_h, n, blocks", "a bearing at standstill has no life in hours: omit L_h, or give the speed"},
          Rule<Input>{[](const Input& in) { return in.blocks.empty() || is_set(highest_speed(in)); }, "n, blocks",
                      "blocks of time need the speed n, or that of each block"},
          Rule<Input>{[](const Input& in) { return !is_set(in.R) || in.a_1 == 1.0; }, "R, a_1",
                      "give either the reliability R or a_1"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.kappa) && is_set(in.nu)); }, "kappa, nu",
                      "give either the viscosity ratio kappa or the viscosity nu"},
          Rule<Input>{[](const Input& in) { return has_film(in) == is_set(in.e_C); }, "e_C, kappa, nu",
                      "a_ISO needs the contamination factor e_C and one of kappa and nu"},
          Rule<Input>{[](const Input& in) { return !has_film(in) || is_set(in.C_u); }, "C_u, kappa, nu",
                      "a_ISO needs the fatigue load limit C_u"},
          Rule<Input>{[](const Input& in) {
                        return !is_set(in.nu) || (is_set(in.d) && is_set(in.D) && highest_speed(in) > 0.0 * rpm);
                      },
                      "nu, d, D, n",
                      "the reference viscosity needs bore, outer diameter and speed: give them, or kappa"},
          Rule<Input>{&shares_close, "blocks", "the shares q of the blocks must sum to 1", &open_shares}},
      block_rules<Input>(), pair_rules<Input>());

  static constexpr bool turns = true;
  static constexpr auto bounds = rolling_bounds<Input>();
  static constexpr std::array modes{
      Mode<Input>{"fatigue", "rating life (raceway fatigue)", &runs}.judged_by("u_L, x_P, x_f"),
      Mode<Input>{"static", "static safety factor (permanent indentation)", &always<Input>}.judged_by("u_0"),
      Mode<Input>{"skidding", "minimum load (skidding)", &runs}
          .judged_by("x_min")
          .wanting("P_min")
          .asking("below the rule of thumb, 0.01 C (balls) or 0.02 C (rollers): give P_min of the manufacturer, or "
                  "accept.skidding = \"...\" (preload)")
          .of_shape(),
      Mode<Input>{"speed", "limiting speed", &runs_fast}.judged_by("u_n"),
      Mode<Input>{"axial", "axial load capability of the type", &always<Input>}.judged_by("F_ao").of_shape(),
      Mode<Input>{"location", "axial location of the shaft", &locates_nothing}.advising(
          "take a type with ribs or a deep groove, or name the part that locates: accept.location = \"...\""),
      Mode<Input>{"radial", "radial load capability of the type", &always<Input>}.judged_by("F_ro").of_shape(),
      Mode<Input>{"ribs", "axial load limit (ribs, groove edges)", &has_axial_bound}.judged_by("u_a").wanting(
          "F_a_adm"),
      Mode<Input>{"mate", "induced axial force", &runs_at_an_angle}.judged_by("x_i").of_shape(),
      Mode<Input>{"pressure_centre", "radial load at the pressure centre", &supports_at_an_angle<Input>}
          .judged_by("x_c")
          .wanting("a")
          .of_shape(),
      Mode<Input>{"seat", "bearing on its seat (bore, width, fillet, shoulder)", &sits_on_a_shaft<Input>}
          .judged_by("x_d, x_B, x_r, x_a")
          .wanting("d")
          .special(),
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions(),
      Mode<Input>{"film", "lubrication and contamination (a_ISO)", &film_is_given<Input>}.judged_by("x_k").special(),
      Mode<Input>{"heat", "operating temperature and grease life", &unseen<Input>}.special(),
      Mode<Input>{"tilt", "misalignment of the rings", &unseen<Input>}.special().assessed_additionally_in(
          "shaft.design"),
      Mode<Input>{"seats", "ring creep on the shaft and housing seats", &unseen<Input>}.special(),
      Mode<Input>{"standstill", "false brinelling, electrical erosion, corrosion", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::bearing
