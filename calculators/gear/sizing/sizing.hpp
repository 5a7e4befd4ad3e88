// Teeth and face width of a pair of external gears for a power and a ratio: every module of series I, number of teeth,
// helix angle and face width of a range, assessed by gear.rating, ranked by mass or centre distance.
//
// The profile shift balances the specific sliding at the roots of both flanks, to two decimals; its sum is given, or
// follows from a centre distance. Gear 2 has the number of teeth next to i z_1, below and above. Face widths are those
// of R20 between the limits of b/d_1, from 6 to 30 modules. Mass of solid cylinders of the reference diameters, without
// bores and webs. A pair passes with all checks and limits of gear.rating; the others ahead of the best one are listed
// with the mode that rejects them, or the nearest to passing if none does. Not covered: multiplication (i below 1),
// rings and racks, load spectra, protuberance tools, tooth numbers without a common factor, and what gear.rating does
// not cover.
#pragma once

#include "calculators/gear/sizing/types.hpp"
#include "lib/calculator/bound.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::gear {

/// The rules of gear.rating on what is not of the teeth.
template <class Input, std::size_t... index>
constexpr auto rules_of_rating(std::index_sequence<index...>) {
  constexpr auto& all = Rating::rules_of_capacity;
  return std::array{Rule<Input>{
      [](const Input& in) { return all[index].holds(in); }, all[index].fields, all[index].text,
      all[index].particulars == nullptr ? nullptr : +[](const Input& in) { return all[index].particulars(in); },
      all[index].only_warns, all[index].modes}...};
}

/// The bounds of gear.rating but the first two: one depends on the teeth, the other on their shaft.
static_assert(std::string_view(Rating::bounds[0].field) == "f_ma");
static_assert(std::string_view(Rating::bounds[1].field) == "f_sh_1");
template <class Input, std::size_t index>
constexpr Bound<Input> bound_of_rating() {
  constexpr auto& of = Rating::bounds[index];
  Bound<Input> bound{of.field, of.text, +[](const Input& in) { return Rating::bounds[index].value(in); }};
  bound.is_least = of.is_least;
  return bound;
}
template <class Input, std::size_t... index>
constexpr auto bounds_of_rating(std::index_sequence<index...>) {
  return std::array{bound_of_rating<Input, index + 2>()...};
}

struct PairSizing : PairSizingTypes {
  static constexpr auto id = "gear.sizing";
  static constexpr auto title = "Gear pair sizing";
  static constexpr auto scope =
      "Ranked selection of module, numbers of teeth, helix angle, profile shifts and face width of external spur and "
      "helical gears for a power or torque and a ratio, with all checks and limits of gear.rating, by mass or centre "
      "distance, with the reason for the rejection of each pair ahead of the best one.";
  static constexpr auto source =
      "[ISO21771], [Modules], [DIN3990-11], [ISO6336-1], [ISO6336-2], [ISO6336-3], [ISO6336-5]";
  static constexpr auto headline = "z {z_1}/{z_2}, m {m_n}, b = {b}";
  static constexpr auto details = "beta = {beta}, x_1 = {x_1}, x_2 = {x_2}, a_w = {a_w}, mass of both gears {mass}";
  static constexpr auto synonyms =
      "gear sizing, gear design, gear pair design, module selection, optimum gear pair, minimum mass, minimum centre "
      "distance, Zahnradauslegung, Verzahnungsauslegung, Grobauslegung, Modulwahl, проектный расчёт зубчатой передачи, "
      "подбор модуля";
  static constexpr bool takes_series = false;  // one pair for all loads
  static constexpr auto example = R"([project]
title = "Gear pair of a hoist"

[pick]
calculator = "gear.sizing"
P = "15 kW"
n_1 = "1450 rpm"
i_set = 4
K_A = 1.25
betas = ["0 deg", "12 deg"]
m_max = "6 mm"
grade = 6
finish = "ground"
R_z1 = "5 um"
R_z2 = "5 um"
material_1 = "case"
material_2 = "case"
quality_1 = "MQ"
quality_2 = "MQ"
H_1 = 720
H_2 = 720
place = "middle"
S_Hmin = 1.1
S_Fmin = 1.4
)";

  static constexpr auto inputs = join(
      Fields{
          Field{&Input::P, "P", kW, "nominal power input of gear 1, replaces T_1"}
              .load()
              .at_least_that_of_source("shafts[#].P")
              .positive()
              .may_be_missing(),
          Field{&Input::T_1, "T_1", N_m, "torque of gear 1, nominal"}
              .load()
              .at_least_that_of_source("shafts[#].T")
              .positive()
              .may_be_missing(),
          Field{&Input::n_1, "n_1", rpm, "speed of gear 1"}.near_that_of_source("shafts[#].n"),
          Field{&Input::i_set, "i_set", ratio, "required gear ratio z_2/z_1"}.also("i").within(1, 20).usually(1, 10),
          Field{&Input::tol_i, "tol_i", ratio, "tolerance of the ratio, relative"}.positive().below(0.3).usually(0.001,
                                                                                                                 0.1),
          Field{&Input::K_A, "K_A", ratio, "application factor K_A (1 if the load includes it)"}
              .at_least(1)
              .usually(1, 2.5)
              .factor(),
          Choice{&Input::idler, "idler", "idler gear (reversed tooth bending)"}.may_be_missing(),
          Choice{&Input::by, "by", "ranking criterion"}.may_be_missing(),
          Field{&Input::a_set, "a_set", mm, "working centre distance, if it is fixed"}
              .also("a_w")
              .positive()
              .may_be_missing(),
          ListField{&Input::betas, "betas", "helix angles to select from; omitted: spur gears"}
              .as_arrays()
              .may_be_missing(),
          Choice{&Input::shift, "shift", "distribution of the profile shift"}.may_be_missing(),
          Field{&Input::x_sum, "x_sum", ratio, "sum of the profile shift coefficients; omitted: from a_w, else zero"}
              .within(-1, 2)
              .usually(-0.5, 1.2)
              .may_be_missing(),
          Count{&Input::z_min, "z_min", 8, 200, "minimum number of teeth of gear 1"}.may_be_missing(),
          Count{&Input::z_max, "z_max", 8, 200, "maximum number of teeth of gear 1"}.may_be_missing(),
          Field{&Input::m_min, "m_min", mm, "minimum normal module (series I of ISO 54)"}.positive().may_be_missing(),
          Field{&Input::m_max, "m_max", mm, "maximum normal module (series I of ISO 54)"}.positive().may_be_missing(),
          Field{&Input::psi_min, "psi_min", ratio, "minimum face width / reference diameter of gear 1"}
              .positive()
              .usually(0.1, 1),
          Field{&Input::psi_max, "psi_max", ratio, "maximum face width / reference diameter of gear 1"}
              .positive()
              .usually(0.2, 1.6),
          Field{&Input::rho, "rho", kg_per_m3, "density of both gears, for their mass"}.positive().usually(6500, 8500),
          Choice{&Input::standard, "standard", "standard of the rating"}.may_be_missing(),
          Choice{&Input::root_edition, "root_edition", "edition of ISO 6336-3"}.may_be_missing(),
          Field{&Input::alpha_n, "alpha_n", deg, "normal pressure angle"}.within(15, 25).usually(17.5, 25),
          Field{&Input::h_aP, "h_aP", ratio, "addendum of the basic rack, in modules"}.within(0.3, 2).usually(0.8, 1.2),
          Field{&Input::h_fP, "h_fP", ratio, "dedendum of the basic rack, in modules"}.within(0.4, 2.5).usually(1, 1.4),
          Field{&Input::rho_fP, "rho_fP", ratio, "root fillet radius of the basic rack, in modules"}.within(0, 0.6),
          Choice{&Input::shortening, "shortening", "tip shortening of a pair with profile shift"}.may_be_missing()},
      Rating::inputs_of_capacity);

  static constexpr Fields results{
      Field{&Result::tried, "tried", ratio, "number of pairs of teeth in the range (module, teeth, helix)"},
      Field{&Result::m_n, "m_n", mm, "normal module"}.chosen(),
      Count{&Result::z_1, "z_1", 0, 2000, "number of teeth, gear 1"}.chosen(),
      Count{&Result::z_2, "z_2", 0, 20000, "number of teeth, gear 2"}.chosen(),
      Field{&Result::beta, "beta", deg, "helix angle at the reference diameter"}.chosen(),
      Field{&Result::b, "b", mm, "common face width"}.chosen(),
      Field{&Result::x_1, "x_1", ratio, "profile shift coefficient, gear 1"}.chosen(),
      Field{&Result::x_2, "x_2", ratio, "profile shift coefficient, gear 2"}.chosen(),
      Field{&Result::a_w, "a_w", mm, "working centre distance"},
      Field{&Result::d_1, "d_1", mm, "reference diameter, gear 1"},
      Field{&Result::d_2, "d_2", mm, "reference diameter, gear 2"},
      Field{&Result::i, "i", ratio, "gear ratio z_2/z_1"},
      Field{&Result::dev_i, "dev_i", ratio, "relative deviation of the ratio"},
      Field{&Result::psi_d, "psi_d", ratio, "face width / reference diameter of gear 1"},
      Field{&Result::zeta_1, "zeta_1", ratio, "specific sliding at the root of gear 1"},
      Field{&Result::zeta_2, "zeta_2", ratio, "specific sliding at the root of gear 2"},
      Field{&Result::mass, "mass", kg, "mass of both gears as solid cylinders of the reference diameters"},
      Field{&Result::F_t, "F_t", N, "nominal tangential force at the reference circle"},
      Field{&Result::v, "v", m_per_s, "velocity at the reference circle"},
      Field{&Result::K_V, "K_V", ratio, "dynamic factor"},
      Field{&Result::K_Hbeta, "K_Hbeta", ratio, "face load factor, contact"},
      Field{&Result::K_Halpha, "K_Halpha", ratio, "transverse load factor, contact"},
      Field{&Result::S_H1, "S_H1", ratio, "safety factor against pitting, gear 1"},
      Field{&Result::S_H2, "S_H2", ratio, "safety factor against pitting, gear 2"},
      Field{&Result::S_F1, "S_F1", ratio, "safety factor against tooth breakage, gear 1"},
      Field{&Result::S_F2, "S_F2", ratio, "safety factor against tooth breakage, gear 2"},
      Field{&Result::u_H1, "u_H1", ratio, "pitting, gear 1: required / calculated safety factor"}.check(),
      Field{&Result::u_H2, "u_H2", ratio, "pitting, gear 2: required / calculated safety factor"}.check(),
      Field{&Result::u_F1, "u_F1", ratio, "tooth breakage, gear 1: required / calculated safety factor"}.check(),
      Field{&Result::u_F2, "u_F2", ratio, "tooth breakage, gear 2: required / calculated safety factor"}.check(),
      Field{&Result::x_v, "x_v", ratio, "related pitch line velocity: the dynamic constants hold below 10"}
          .limit(0, 10)
          .where_it_applies(),
      Field{&Result::x_c, "x_c", ratio, "sum of the profile shifts: the series of the stiffness holds from -0.5 to 2"}
          .limit(-0.5, 2)
          .where_it_applies(),
      Field{&Result::x_eps, "x_eps", ratio, "transverse contact ratio: the method holds from 1 to 2"}.limit(1, 2),
      Field{&Result::x_free, "x_free", ratio, "undercut: minimum margin of profile shift to the undercut limit"}
          .limit(-0.02, 100)
          .criterion(),
      Field{&Result::s_a, "s_a", ratio, "tip thickness: minimum in modules (0.2; case-hardened 0.4)"}
          .limit(0.2, 100)
          .criterion(),
      Field{&Result::f_int, "f_int", ratio, "interference: minimum clearance between tips and fillets, in modules"}
          .limit(-0.01, 1e4)
          .criterion(),
      Field{&Result::c_n, "c_n", mm, "tip clearance, the smaller one"}.limit(-1e-6, 1e4).criterion(),
      Field{&Result::found, "found", ratio, "number of pairs found that pass every check and limit, ten at most"}
          .limit(1, 10)
          .criterion(),
      Group{&Result::best, "best", "best pair, for gear.rating: mesh = \"=pick.best\"; for gear.pair: pair"}
          .handed_over(),
      ListField{&Result::candidates, "candidates", "pairs that pass, best first"},
      ListField{&Result::rejected, "rejected",
                "rejected pairs with the reason: those ahead of the best one; if none passes, the nearest to passing"}};

  static constexpr auto rules = join(
      std::array{
          Rule<Input>{[](const Input& in) { return is_set(in.T_1) != is_set(in.P); }, "T_1, P",
                      "give the load either as T_1 or as P"},
          Rule<Input>{[](const Input& in) { return is_set(in.S_Hmin) && is_set(in.S_Fmin); }, "S_Hmin, S_Fmin",
                      "the gears are sized for the required safety factors: give S_Hmin and S_Fmin"},
          Rule<Input>{[](const Input& in) { return in.z_min <= in.z_max; }, "z_min, z_max",
                      "the minimum number of teeth must not exceed the maximum"},
          Rule<Input>{[](const Input& in) { return !(in.m_min > in.m_max); }, "m_min, m_max",
                      "the minimum module must not exceed the maximum"},
          Rule<Input>{[](const Input& in) { return in.psi_min <= in.psi_max; }, "psi_min, psi_max",
                      "the minimum face width must not exceed the maximum"},
          Rule<Input>{[](const Input& in) { return !(is_set(in.a_set) && is_set(in.x_sum)); }, "a_set, x_sum",
                      "the centre distance sets the sum of the profile shifts: omit x_sum"},
          Rule<Input>{
              [](const Input& in) { return in.shift == Shift::balanced || !(is_set(in.a_set) || is_set(in.x_sum)); },
              "shift, a_set, x_sum",
              "gears without profile shift have no choice of a_set or x_sum: shift = \"balanced\""},
          Rule<Input>{[](const Input& in) { return in.place != Place::untold; }, "place",
                      "give the position of the pinion relative to the bearings: place = \"middle\", or \"a\" to "
                      "\"e\""}},
      rules_of_rating<Input>(std::make_index_sequence<Rating::rules_of_capacity.size()>{}));

  static double least_deviation(const Input& in);
  static constexpr auto bounds =
      join(std::array{Bound<Input>{"f_ma", "the helix slope tolerance of the grade", &least_deviation}.least()},
           bounds_of_rating<Input>(std::make_index_sequence<Rating::bounds.size() - 2>{}));
  static constexpr std::array meanings{Meaning{"best.z_1, best.T_1", flanks_ground, "finish", "ground"}};
  static constexpr std::array senses{SenseClaim{"T_1, P", "idler", "none, gear_1, gear_2", "both"}};
  static constexpr bool turns = true;

  static constexpr std::array modes{
      Mode<Input>{"pairs", "availability of a pair in the range", &always<Input>}
          .judged_by("found")
          .advising("widen the range (m_max, psi_max, z_max, tol_i); else take another a_set, a harder material or two "
                    "stages")
          .of_shape(),
      Mode<Input>{"pitting_1", "pitting, gear 1", &always<Input>}.judged_by("u_H1, x_eps"),
      Mode<Input>{"pitting_2", "pitting, gear 2", &always<Input>}.judged_by("u_H2, x_eps"),
      Mode<Input>{"root_1", "tooth breakage, gear 1", &always<Input>}.judged_by("u_F1, x_eps"),
      Mode<Input>{"root_2", "tooth breakage, gear 2", &always<Input>}.judged_by("u_F2, x_eps"),
      Mode<Input>{"dynamic", "dynamic tooth load", &always<Input>}.judged_by("x_v, x_c"),
      Mode<Input>{"undercut", "undercut", &always<Input>}.judged_by("x_free").of_shape(),
      Mode<Input>{"pointed", "tip thickness", &always<Input>}.judged_by("s_a").of_shape(),
      Mode<Input>{"interference", "tip and fillet interference", &always<Input>}.judged_by("f_int").of_shape(),
      Mode<Input>{"clearance", "tip clearance", &always<Input>}.judged_by("c_n").of_shape(),
      Mode<Input>{"backlash", "backlash", &unseen<Input>}
          .advising("take the best pair in gear.pair, with the tooth thickness allowances A_s1 and A_s2")
          .special(),
      Mode<Input>{"overload", "tooth overload at peak torque", &unseen<Input>}.special(),
      Mode<Input>{"scuffing", "scuffing", &unseen<Input>}.special(),
      Mode<Input>{"micropitting", "micropitting", &unseen<Input>}.special(),
      Mode<Input>{"case_crushing", "case crushing", &unseen<Input>}.special(),
      Mode<Input>{"wear", "wear of the tooth flanks", &unseen<Input>}.special(),
      Mode<Input>{"heat", "thermal capacity", &unseen<Input>}.special()};

  /// The best pair, as gear.pair draws it.
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::gear
