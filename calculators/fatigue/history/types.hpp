// Input and result of fatigue.history.
#pragma once

#include "calculators/fatigue/history/dnv.hpp"
#include "calculators/fatigue/mean_stress.hpp"
#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::fatigue {

struct HistoryTypes {
  enum class Counting { four_point, hcm, astm };
  enum class Residue { repeated, half_cycles, ignored };
  enum class Curve { part, en1993, dnv };
  using Detail = DnvDetail;
  /// How mean stresses count: not at all, or by a rule.
  enum class Means { none, goodman, soderberg, gerber, elliptic, morrow, swt, walker, fkm };
  /// Whether the damage by other rules than the one that decides is computed.
  enum class OtherRules { untold, yes, no };
  enum class MinerRule { original, elementary, modified, consistent, liu_zenner };

  struct Block {
    Name name;
    Stress sigma_a = unset<Stress>, sigma_m = 0.0 * MPa;
    double n = unset<double>;
    static constexpr Fields fields{
        NameField{&Block::name, "name", "name of the block"}.may_be_missing(),
        Field{&Block::sigma_a, "sigma_a", MPa, "amplitude"}.at_least(0).load(),
        Field{&Block::sigma_m, "sigma_m", MPa, "mean stress, signed"}.load(),
        Field{&Block::n, "n", ratio, "cycles, in one passage of the history"}.positive().usually(1e-3, 1e12)};
  };
  static constexpr std::size_t most_blocks = 64;

  struct Input {
    Varying<Stress> sigma;
    List<Block, most_blocks> blocks;
    Stresses stress = Stresses::normal;
    double K_A = 1.0, S_D = 1.0;
    Counting counting = Counting::four_point;
    Residue residue = Residue::repeated;
    Stress gate = 0.0 * MPa;
    Curve curve = Curve::part;
    Stress sigma_D = unset<Stress>;
    double N_D = unset<double>, k = unset<double>;
    MinerRule miner = MinerRule::modified;
    OtherRules other_rules = OtherRules::untold;
    Stress sigma_C = unset<Stress>;
    Detail detail = Detail::untold;
    double lg_a = unset<double>, m_1 = unset<double>, m_2 = unset<double>, N_1 = unset<double>;
    Means mean = Means::none;
    double M = unset<double>, gamma = unset<double>;
    Stress sigma_f = unset<Stress>;
    Length d_h = unset<Length>;
    Stress R_m = unset<Stress>, R_e = unset<Stress>, E = unset<Stress>;
    Density rho = unset<Density>;
    double S_F = unset<double>;
    double D_adm = 1.0, n_req = unset<double>, N_eq = unset<double>;
    Time t = unset<Time>;
    Whole classes = 0;
  };
  static bool is_of_part(const Input& in) { return in.curve == Curve::part; }
  /// Sorting a long history only to compare rules takes time; it is done on request.
  static bool compares_rules(const Input& in) {
    constexpr std::size_t most_compared = 100'000;
    return in.other_rules == OtherRules::yes ||
           (in.other_rules == OtherRules::untold && in.sigma.positions() <= most_compared);
  }

  /// A cycle that does much of the damage.
  struct Worst {
    Stress sigma_a = unset<Stress>, sigma_m = unset<Stress>;
    double n = unset<double>, share = unset<double>, from = unset<double>, to = unset<double>;
    static constexpr Fields fields{
        Field{&Worst::sigma_a, "sigma_a", MPa, "amplitude, with the application factor"},
        Field{&Worst::sigma_m, "sigma_m", MPa, "mean stress, with the application factor"},
        Field{&Worst::n, "n", ratio, "count, half cycles as 0.5"},
        Field{&Worst::share, "share", ratio, "of the damage"},
        Field{&Worst::from, "from", ratio, "start: sample of a file, position of a revolution, counted from 0"},
        Field{&Worst::to, "to", ratio, "end: sample or position"}};
  };
  static constexpr std::size_t most_worst = 10;

  /// Cycles of one direction, by the middles of the classes that they begin and end in.
  struct Cell {
    Stress from = unset<Stress>, to = unset<Stress>;
    double n = unset<double>;
    static constexpr Fields fields{Field{&Cell::from, "from", MPa, "begin: middle of the class"},
                                   Field{&Cell::to, "to", MPa, "end: middle of the class"},
                                   Field{&Cell::n, "n", ratio, "cycles, halves as 0.5"}};
  };
  struct RangePair {
    Stress from = unset<Stress>, to = unset<Stress>;
    double n = unset<double>, n_least = unset<double>;
    static constexpr Fields fields{Field{&RangePair::from, "from", MPa, "range of the class, lower end"},
                                   Field{&RangePair::to, "to", MPa, "range of the class, upper end"},
                                   Field{&RangePair::n, "n", ratio, "cycles of this range, half cycles as 0.5"},
                                   Field{&RangePair::n_least, "n_least", ratio, "cycles at least so large"}};
  };
  struct Crossing {
    Stress sigma = unset<Stress>;
    double up = unset<double>, down = unset<double>;
    static constexpr Fields fields{Field{&Crossing::sigma, "sigma", MPa, "level: a bound of classes"},
                                   Field{&Crossing::up, "up", ratio, "crossings upwards"},
                                   Field{&Crossing::down, "down", ratio, "crossings downwards"}};
  };

  struct Result {
    double n = unset<double>;
    Stress sigma_max = unset<Stress>, sigma_min = unset<Stress>, sigma_a1 = unset<Stress>, sigma_mean = unset<Stress>;
    Stress S_1 = unset<Stress>;
    double N_S1 = unset<double>;
    double D_original = unset<double>, D_elementary = unset<double>, D_modified = unset<double>,
           D_consistent = unset<double>, D_LZ = unset<double>;
    double D = unset<double>, Z = unset<double>;
    Time L = unset<Time>;
    Stress S_eq = unset<Stress>;
    double u_y = unset<double>, u_F = unset<double>, u_m = unset<double>, u_D = unset<double>, x_N = unset<double>,
           x_B = unset<double>, x_R = unset<double>, x_g = unset<double>, x_O = unset<double>;
    List<Worst, most_worst> worst;
    std::vector<Cell> matrix;
    std::vector<RangePair> range_pairs;
    std::vector<Crossing> crossings;
  };
};

constexpr auto choices_of(HistoryTypes::Counting) {
  using C = HistoryTypes::Counting;
  return std::array{ChoiceName<C>{C::four_point, "four-point", "rainflow by four points"},
                    ChoiceName<C>{C::hcm, "hcm", "hysteresis counting of Clormann and Seeger"},
                    ChoiceName<C>{C::astm, "astm", "ASTM E1049, rainflow"}};
}
constexpr auto choices_of(HistoryTypes::Residue) {
  using R = HistoryTypes::Residue;
  return std::array{ChoiceName<R>{R::repeated, "repeated", "the history repeats: full cycles only"},
                    ChoiceName<R>{R::half_cycles, "half-cycles", "each range is half a cycle (history not repeated)"},
                    ChoiceName<R>{R::ignored, "ignored", "not counted: on the unsafe side"}};
}
constexpr auto choices_of(HistoryTypes::Curve) {
  using C = HistoryTypes::Curve;
  return std::array{
      ChoiceName<C>{C::part, "part", "amplitudes, sigma_D at N_D with the slope k"},
      ChoiceName<C>{C::en1993, "en1993", "ranges by EN 1993-1-9:2005: slopes 3 and 5, none below the cut-off; shear 5"},
      ChoiceName<C>{C::dnv, "dnv", "ranges by DNV-RP-C203: two slopes without an end"}};
}
constexpr auto choices_of(HistoryTypes::Means) {
  using M = HistoryTypes::Means;
  const auto as = [](M means, MeanRule rule) { return ChoiceName<M>{means, word_of(rule), choice_of(rule).doc}; };
  return std::array{ChoiceName<M>{M::none, "none", "not at all: right without tension, and for welded details"},
                    as(M::goodman, MeanRule::goodman),
                    as(M::soderberg, MeanRule::soderberg),
                    as(M::gerber, MeanRule::gerber),
                    as(M::elliptic, MeanRule::elliptic),
                    as(M::morrow, MeanRule::morrow),
                    as(M::swt, MeanRule::swt),
                    as(M::walker, MeanRule::walker),
                    as(M::fkm, MeanRule::fkm)};
}
constexpr auto choices_of(HistoryTypes::OtherRules) {
  using O = HistoryTypes::OtherRules;
  return std::array{ChoiceName<O>{O::untold, "", "of histories up to 100,000 samples"},
                    ChoiceName<O>{O::yes, "yes", "computed"}, ChoiceName<O>{O::no, "no", "not computed"}};
}
constexpr auto choices_of(HistoryTypes::MinerRule) {
  using M = HistoryTypes::MinerRule;
  return std::array{
      ChoiceName<M>{M::original, "original", "no damage below the fatigue limit: valid if no cycle exceeds it"},
      ChoiceName<M>{M::elementary, "elementary", "slope k throughout: no fatigue limit"},
      ChoiceName<M>{M::modified, "modified", "Haibach: slope 2 k - 1 below the fatigue limit"},
      ChoiceName<M>{M::consistent, "consistent", "the fatigue limit falls with the damage"},
      ChoiceName<M>{M::liu_zenner, "liu-zenner", "one slope (k + 3.6)/2, down to half of the limit"}};
}

}  // namespace loadpath::fatigue
