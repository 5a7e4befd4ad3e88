// A history of stress against fatigue: its cycles by rainflow, their damage by Miner's rule, the allowable repetitions.
//
// Decides the cycles of a series - one turn of a mechanism, a file of any length - or takes blocks; the equivalent
// amplitude of each at r = -1; the damage sum by a curve of the part, by a detail of [EN1993-1-9] or of [DNVC203]; the
// largest stress against yielding. One turn repeats; so does a file, unless its residue is counted otherwise. Stresses
// are nominal, amplitudes for the curve of a part and ranges for a detail, lives are cycles and not reversals, at the
// survival probability of the curve. Not covered: several stresses at once, low-cycle fatigue, the order of the loads.
// Not checked against the source: the consistent rule and the rule of Liu and Zenner.
#pragma once

#include "calculators/fatigue/history/dnv.hpp"
#include "calculators/fatigue/history/types.hpp"
#include "calculators/fatigue/mean_stress.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <limits>
#include <vector>

namespace loadpath::fatigue {

struct History : HistoryTypes {
  static constexpr auto id = "fatigue.history";
  static constexpr auto title = "Variable-amplitude fatigue (rainflow, Miner)";
  static constexpr auto scope =
      "Rainflow counting of a stress history (one mechanism cycle or a file) or of load blocks, Miner damage "
      "with the S-N curve of a part or a welded detail, number of allowable repetitions, and yielding, for one "
      "nominal stress component.";
  static constexpr auto source = "[E1049], [HCM], [Miner], [Haibach], [EN1993-1-9], [DNVC203], [FKM]";
  static constexpr auto headline = "n = {n}|D = {D}";
  static constexpr auto subject = "fatigue";
  static constexpr auto synonyms =
      "rainflow, cycle counting, Miner, Palmgren-Miner, damage sum, load spectrum, load history, "
      "variable amplitude, blocks, Haibach, HCM, ASTM E1049, welded detail, FAT class, detail category, "
      "EN 1993-1-9, DNV-RP-C203, Lastkollektiv, Betriebsfestigkeit, Schadenssumme, Rainflow-Zählung, "
      "спектр нагрузок, линейное суммирование повреждений, метод дождя";
  static constexpr auto example = R"([project]
title = "A bracket under three blocks of load"

[bracket]
calculator = "fatigue.history"
blocks = [
  { sigma_a = "180 MPa", n = 500 },
  { sigma_a = "140 MPa", sigma_m = "40 MPa", n = 8000 },
  { sigma_a = "90 MPa", sigma_m = "40 MPa", n = 120000 },
]
sigma_D = "120 MPa"
N_D = 1e6
k = 5
mean = "goodman"
R_m = "690 MPa"
R_e = "490 MPa"
S_F = 1.5
n_req = 1
)";

  static constexpr int most_classes = 32;
  static Applies has_tension(const Input& in);
  /// Curves of details are those of steel; the rules that reckon with a fatigue limit need a metal that has one.
  static Applies lacks_limit(const Input& in) {
    const bool endless = in.miner == MinerRule::modified || in.miner == MinerRule::elementary;
    return where(lacks_fatigue_limit(in) && !(is_of_part(in) && endless));
  }
  static Applies leaves_residue(const Input& in) {
    return where(in.sigma.is_series() && in.residue == Residue::ignored);
  }
  static constexpr Fields inputs{
      Field{&Input::sigma, "sigma", MPa,
            "nominal stress over the history: a series, or { file, column, unit }, or { values, unit }"}
          .load()
          .may_be_missing(),
      ListField{&Input::blocks, "blocks", "cycles in blocks, in place of a series"}.may_be_missing(),
      Choice{&Input::stress, "stress", "stress component: normal or shear"}.may_be_missing(),
      Field{&Input::K_A, "K_A", ratio, "application factor K_A on the stresses (1 if they include it)"}
          .at_least(1)
          .usually(1, 4)
          .factor(),
      Field{&Input::S_D, "S_D", ratio, "safety on stress against fatigue: of codes gamma_Ff gamma_Mf"}
          .at_least(1)
          .usually(1, 3)
          .factor(),
      Choice{&Input::counting, "counting", "method of counting"}.may_be_missing(),
      Choice{&Input::residue, "residue", "treatment of the rainflow residue"}.may_be_missing(),
      Field{&Input::gate, "gate", MPa, "ranges below are not counted"}.at_least(0),
      Choice{&Input::curve, "curve", "S-N curve"}.may_be_missing(),
      Field{&Input::sigma_D, "sigma_D", MPa, "curve of a part: fatigue limit, amplitude at r = −1"}
          .positive()
          .usually(1, 1500)
          .may_be_missing(),
      Field{&Input::N_D, "N_D", ratio, "curve of a part: cycles at its knee"}
          .at_least(1e3)
          .usually(1e5, 1e8)
          .may_be_missing(),
      Field{&Input::k, "k", ratio, "curve of a part: its slope"}.within(1, 32).usually(3, 20).may_be_missing(),
      Choice{&Input::miner, "miner", "rule for cycles below the fatigue limit, of the curve of a part"}
          .may_be_missing(),
      Choice{&Input::other_rules, "other_rules", "damage by the other rules, for comparison"}.may_be_missing(),
      Field{&Input::sigma_C, "sigma_C", MPa, "detail of EN 1993-1-9: its category, the range at 2e6 cycles"}
          .positive()
          .usually(30, 200)
          .may_be_missing(),
      Choice{&Input::detail, "detail", "detail of DNV-RP-C203 in air, edition 2016, in place of lg_a"}.may_be_missing(),
      Field{&Input::lg_a, "lg_a", ratio,
            "detail of DNV-RP-C203: lg a of its first branch, N = a S^-m_1, S the range in MPa; C in air 12.592"}
          .within(5, 40)
          .may_be_missing(),
      Field{&Input::m_1, "m_1", ratio, "the same: slope of the first branch; omitted: 3"}
          .within(1, 20)
          .usually(3, 5)
          .may_be_missing(),
      Field{&Input::m_2, "m_2", ratio, "slope of the second branch; omitted: 5"}
          .within(1, 40)
          .usually(5, 9)
          .may_be_missing(),
      Field{&Input::N_1, "N_1", ratio, "cycles where the branches meet; omitted: 1e7"}.at_least(1e4).may_be_missing(),
      Choice{&Input::mean, "mean", "mean stress correction, with the curve of a part"}.may_be_missing(),
      Field{&Input::M, "M", ratio, "mean stress sensitivity, for mean = \"fkm\": of steel 0.35e-3 R_m/MPa - 0.1"}
          .within(0, 1)
          .usually(0.01, 0.8)
          .may_be_missing(),
      Field{&Input::gamma, "gamma", ratio, "exponent of Walker"}
          .within(0, 1)
          .usually(0.3, 0.9)
          .customarily_at_most(0.9)
          .may_be_missing(),
      Field{&Input::sigma_f, "sigma_f", MPa, "fatigue strength coefficient of Morrow: of the true fracture stress"}
          .positive()
          .usually(200, 4000)
          .may_be_missing(),
      diameter_at_heat_treatment(&Input::d_h).at_least_that_of_source("d_s, t, d_h"),
      Field{&Input::R_m, "R_m", MPa, "tensile strength"}
          .positive()
          .usually(80, 2500)
          .customarily_at_most(most_tensile_strength)
          .from("material", "R_m", "d_h"),
      Field{&Input::R_e, "R_e", MPa, "yield strength"}
          .positive()
          .usually(50, 2500)
          .customarily_at_most(most_yield_strength)
          .from("material", "R_e", "d_h"),
      modulus_of_material(&Input::E),
      density_of_material(&Input::rho),
      Field{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
          .at_least(1)
          .usually(1, 6)
          .customarily_at_least(1.1)
          .may_be_missing()
          .factor(),
      Field{&Input::D_adm, "D_adm", ratio, "allowable damage sum; of the relative rule below 1, as 0.3"}
          .within(0, 1)
          .positive()
          .usually(0.1, 1),
      Field{&Input::n_req, "n_req", ratio, "required repetitions of the history, at least 1"}
          .at_least(1)
          .may_be_missing(),
      Field{&Input::N_eq, "N_eq", ratio, "cycles of the equivalent stress of one size"}.positive().may_be_missing(),
      Field{&Input::t, "t", hour, "time of one passage; of a mechanism from its speed"}.positive().may_be_missing(),
      Count{&Input::classes, "classes", 0, most_classes,
            "classes for matrix, range pairs and crossings of a series; a bound belongs below; 0: none"}
          .may_be_missing()};

  static constexpr Fields results{
      Field{&Result::n, "n", ratio, "cycles of one passage, halves as 0.5"},
      Field{&Result::sigma_max, "sigma_max", MPa, "maximum stress, with the application factor"}.holding("K_A"),
      Field{&Result::sigma_min, "sigma_min", MPa, "minimum stress, with the application factor"}.holding("K_A"),
      Field{&Result::sigma_a1, "sigma_a1", MPa, "amplitude of the most damaging cycle"}.holding("K_A"),
      Field{&Result::sigma_mean, "sigma_mean", MPa, "mean stress of the most damaging cycle"}.holding("K_A"),
      Field{&Result::S_1, "S_1", MPa,
            "equivalent stress of the most damaging cycle, with S_D: amplitude at r = −1, or range of a detail"},
      Field{&Result::N_S1, "N_S1", ratio, "cycles to failure at this stress"}.may_be_infinite(),
      Field{&Result::D_original, "D_original", ratio, "damage of one passage, Miner's original rule"},
      Field{&Result::D_elementary, "D_elementary", ratio, "the same, elementary: one slope for all"},
      Field{&Result::D_modified, "D_modified", ratio, "the same, modified by Haibach: 2 k - 1 below the knee"},
      Field{&Result::D_consistent, "D_consistent", ratio, "the same, consistent: the fatigue limit falls"},
      Field{&Result::D_LZ, "D_LZ", ratio, "the same by Liu and Zenner"},
      Field{&Result::D, "D", ratio, "damage of one passage, by the governing rule"},
      Field{&Result::Z, "Z", ratio, "allowable repetitions; infinite if no cycle causes damage"}.may_be_infinite(),
      Field{&Result::L, "L", hour, "life"}.may_be_infinite(),
      Field{&Result::S_eq, "S_eq", MPa,
            "constant stress with the damage of n_req passages in N_eq cycles: amplitude of a part, range of a detail"},
      Field{&Result::u_y, "u_y", ratio, "yielding: maximum stress / yield strength"}.check("R_e"),
      Field{&Result::u_F, "u_F", ratio, "yielding: required / calculated safety factor"}.check("S_F"),
      Field{&Result::u_m, "u_m", ratio, "maximum mean stress / strength at which its rule ends"}
          .check()
          .where_it_applies(),
      Field{&Result::u_D, "u_D", ratio, "damage of n_req passages over the allowable sum"}.check("n_req"),
      Field{&Result::x_N, "x_N", ratio, "minimum life of a cycle: below about 1e3 the curve differs"}
          .limit(1e3, std::numeric_limits<double>::infinity())
          .where_it_applies(),
      Field{&Result::x_B, "x_B", ratio,
            "maximum stress, or amplitude on the curve of a part, over the tensile strength, where every curve ends"}
          .limit(0, 1, "R_m")
          .criterion(),
      Field{&Result::x_R, "x_R", ratio, "maximum range of a detail over 1.5 R_e, [EN1993-1-9] 8"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Result::x_g, "x_g", ratio, "damage of the cycles omitted by the gate / damage of all cycles"}
          .limit(0, 0.01)
          .where_it_applies(),
      Field{&Result::x_O, "x_O", ratio,
            "original Miner rule with a cycle above the limit: damage share by Haibach of the cycles below it; they "
            "are not counted as long as all are below"}
          .limit(0, 0.01)
          .where_it_applies(),
      ListField{&Result::worst, "worst", "most damaging cycles"},
      ListField{&Result::matrix, "matrix", "rainflow matrix, non-empty classes, with the application factor"},
      ListField{&Result::range_pairs, "range_pairs", "range pairs, in descending order"},
      ListField{&Result::crossings, "crossings", "level crossings, the highest first, without the gate"}};

  static bool one_source(const Input& in);
  static bool is_history(const Input& in) { return !is_set(in.sigma.one); }
  static bool curve_given(const Input& in);
  static FieldFault missing_of_curve(const Input& in);
  static bool curve_alone(const Input& in);
  static bool curve_is_of_dnv(const Input& in);
  static bool comes_once(const Input& in);
  static FieldFault comes_never(const Input& in);
  static bool mean_given(const Input& in);
  static bool slopes_fall(const Input& in);
  static bool mean_suits(const Input& in);
  static bool may_be_left(const Input& in);
  static bool varies(const Input& in);
  static bool hcm_repeats(const Input& in) {
    return in.counting != Counting::hcm || in.residue != Residue::half_cycles;
  }
  static constexpr std::array rules{
      Rule<Input>{&one_source, "sigma, blocks", "give either the stress sigma as a series or blocks"},
      Rule<Input>{&is_history, "sigma",
                  "a single value is not a load history: refer to the series, without peak, max or mean, or "
                  "give blocks"},
      Rule<Input>{&curve_given, "curve, sigma_D, N_D, k, sigma_C, detail, lg_a", "a value of the S-N curve is missing",
                  &missing_of_curve},
      Rule<Input>{&curve_alone, "curve, sigma_D, N_D, k, sigma_C, detail, lg_a, m_1, m_2, N_1",
                  "give only the numbers of the chosen curve: sigma_D, N_D and k of a part; sigma_C of EN "
                  "1993-1-9; detail, or lg_a, of DNV-RP-C203"},
      Rule<Input>{[](const Input& in) { return in.detail == Detail::untold || !(is_set(in.lg_a) || is_set(in.m_1)); },
                  "detail, lg_a, m_1", "the detail has its own lg a and slope: give detail, or lg_a with m_1"},
      Rule<Input>{&slopes_fall, "m_1, m_2", "the second branch must be flatter than the first: m_2 > m_1"},
      Rule<Input>{&curve_is_of_dnv, "lg_a, m_1, m_2, N_1",
                  "no detail of DNV-RP-C203 lasts so long: with m_1 = 3 lg_a is 12.592 at most, C in air, and 15.117 "
                  "with 4, B1; 16.320 is that of a second branch. Take the curve by its name: detail = \"C\""},
      Rule<Input>{&comes_once, "blocks, n_req", "a block must occur at least once", &comes_never},
      Rule<Input>{
          [](const Input& in) { return !(in.sigma_C > (in.stress == Stresses::shear ? 100.0 * MPa : 160.0 * MPa)); },
          "sigma_C, stress", "categories of EN 1993-1-9 end at 160 MPa, of shear at 100 MPa"},
      Rule<Input>{&mean_suits, "mean, curve, stress",
                  "a detail counts ranges, whatever their mean; SWT, Walker and Morrow are of normal stresses"},
      Rule<Input>{&mean_given, "mean, R_m, R_e, sigma_f, gamma, M",
                  "the rule for mean stresses needs its number: R_m for goodman and gerber, R_e for soderberg and "
                  "elliptic, sigma_f "
                  "for morrow, gamma for walker, M for fkm"},
      Rule<Input>{&may_be_left, "residue, sigma", "a revolution of a mechanism repeats: its residue must be repeated"},
      Rule<Input>{[](const Input& in) { return !in.sigma.is_series() || resolves_extremes(*in.sigma.series); }, "sigma",
                  "36 positions of a turn at least, and between them extremes no more than 1 % of the range larger: "
                  "take more"},
      Rule<Input>{&hcm_repeats, "counting, residue",
                  "HCM begins on a branch that closes nothing: repeat the history, or count by four points"},
      Rule<Input>{[](const Input& in) { return in.classes == 0 || in.sigma.is_series(); }, "classes, blocks",
                  "classes sort the cycles of a series; blocks are classes already"},
      Rule<Input>{&varies, "sigma", "a constant stress is not a load history"},
      lasts_below_tensile<&Input::sigma_D, Input>("sigma_D, R_m"),
      safety_has_its_yield<Input>(),
      yields_before_it_breaks<Input>()};

  static constexpr std::array meanings{Meaning{"sigma_D", limit_in_normal, "stress", "normal"},
                                       Meaning{"sigma_D", limit_in_shear, "stress", "shear"},
                                       Meaning{"blocks.sigma_a", "amplitude"}, Meaning{"blocks.sigma_m", steady_part}};

  static constexpr std::array modes{
      Mode<Input>{"yield", "first-cycle yielding", &always<Input>}.judged_by("u_y, u_F"),
      Mode<Input>{"fatigue", "cumulative fatigue damage", &always<Input>}
          .judged_by("u_D, u_m, x_N, x_B, x_R, x_g, x_O")
          .wanting("n_req"),
      Mode<Input>{"metal", "fatigue without a fatigue limit (miner = modified or elementary)", &lacks_limit},
      Mode<Input>{"mean", "mean stress effect", &has_tension}.wanting("mean"),
      Mode<Input>{"residue", "damage of the rainflow residue", &leaves_residue},
      Mode<Input>{"notch", "local yielding at the notch root", &unseen<Input>},
      Mode<Input>{"multiaxial", "additional stress components", &unseen<Input>}
          .by_companions()
          .assessed_additionally_in("fatigue.multiaxial"),
      Mode<Input>{"surroundings", "corrosion, heat and fretting", &unseen<Input>}.special()};

  static constexpr bool takes_series = false;
  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

}  // namespace loadpath::fatigue
