#include "calculators/fatigue/history/history.hpp"

#include "calculators/fatigue/history/classes.hpp"
#include "calculators/fatigue/history/curve.hpp"
#include "calculators/fatigue/history/cycles.hpp"
#include "calculators/fatigue/history/figure.hpp"
#include "calculators/fatigue/history/means.hpp"
#include "calculators/fatigue/history/weighing.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/rainflow/damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::fatigue {

namespace {

using Input = History::Input;
using Result = History::Result;
using Curve = History::Curve;
using MinerRule = History::MinerRule;
using rainflow::Cycle;

constexpr double endless = std::numeric_limits<double>::infinity();

/// The rules for the damage: the one that decides, and those to compare it with.
std::vector<MinerRule> rules_of(const Input& in) {
  using Rule = MinerRule;
  if (!History::is_of_part(in)) return {Rule::original};
  if (History::compares_rules(in))
    return {Rule::original, Rule::elementary, Rule::modified, Rule::consistent, Rule::liu_zenner};
  if (in.miner == Rule::original) return {Rule::original, Rule::modified};  // shows the damage it neglects
  return {in.miner};
}

/// The rule that weighs single cycles: for the consistent one, which has no curve, that of Haibach.
MinerRule weighing_rule(const Input& in) { return in.miner == MinerRule::consistent ? MinerRule::modified : in.miner; }

/// The maximum stress on the curve, for curves that depend on it; else unset.
double largest_for(const Input& in, const std::vector<MinerRule>& rules) {
  const bool depends = in.curve == Curve::en1993 || std::ranges::find(rules, MinerRule::liu_zenner) != rules.end();
  return depends ? largest_on_curve(in) : unset<double>;
}

/// A history on its curves.
struct Weights {
  rainflow::SnCurve curve;  // weighs single cycles
  HistoryDamage weighed;
  std::vector<MinerRule> rules;
  std::vector<double> damage;  // of each rule
};
Weights weights_of(const Input& in) {
  Weights w;
  w.rules = rules_of(in);
  const double largest = largest_for(in, w.rules);
  w.curve = curve_by(weighing_rule(in), in, largest);
  std::vector<rainflow::SnCurve> curves{w.curve};
  for (const MinerRule rule : w.rules) {
    if (rule != MinerRule::consistent && rule != weighing_rule(in)) curves.push_back(curve_by(rule, in, largest));
  }
  const bool consistent = std::ranges::find(w.rules, MinerRule::consistent) != w.rules.end();
  w.weighed = weigh(in, curves, consistent);
  std::size_t next = 1;
  for (const MinerRule rule : w.rules) {
    if (rule != MinerRule::consistent) {
      w.damage.push_back(w.weighed.damage[rule == weighing_rule(in) ? 0 : next++]);
    } else {
      const auto found = rainflow::consistent_damage(curve_of(in), std::move(w.weighed.levels));
      w.damage.push_back(found ? *found : unset<double>);
    }
  }
  return w;
}

/// Sample of a file, position of a turn.
double place_of(const Input& in, std::uint64_t index) {
  const auto place = static_cast<std::size_t>(index);
  if (!in.sigma.is_series() || is_turn(in)) return static_cast<double>(place);
  const auto& at = in.sigma.series->signature.axis->at;
  return place < at.size() ? at[place] : unset<double>;
}

void write_worst(const Input& in, const HistoryDamage& weighed, Result& r) {
  const double all = weighed.damage.front();
  const bool placed = in.blocks.empty();
  for (const DamagingCycle& worst : weighed.worst) {
    const Cycle& c = worst.cycle;
    r.worst.push_back(
        {in.K_A * amplitude_of(c), in.K_A * mean_of(c), c.count, all > 0.0 ? worst.damage / all : unset<double>,
         placed ? place_of(in, c.where.begin) : unset<double>, placed ? place_of(in, c.where.end) : unset<double>});
  }
}

template <class Tracer>
void all_rules(const Input& in, const Weights& w, Result& r, Tracer& trace) {
  const auto by = [&](MinerRule rule) {
    const auto found = std::ranges::find(w.rules, rule);
    return found == w.rules.end() ? unset<double> : w.damage[static_cast<std::size_t>(found - w.rules.begin())];
  };
  const auto traced = [&](const char* symbol, MinerRule rule, const char* text) {
    return is_set(by(rule)) ? trace.value(symbol, by(rule), text) : unset<double>;
  };
  if (!History::is_of_part(in)) {
    r.D = trace.value("D", by(MinerRule::original), "sum of n / N over the cycles, [Miner]");
    return;
  }
  r.D_original = traced("D_original", MinerRule::original, "sum of n / N above the limit, [Miner]");
  r.D_elementary = traced("D_elementary", MinerRule::elementary, "the slope k for all cycles");
  r.D_modified = traced("D_modified", MinerRule::modified, "2 k - 1 below the limit, [Haibach]");
  r.D_consistent = traced("D_consistent", MinerRule::consistent,
                          "decreasing fatigue limit, [Haibach], not checked against the source");
  r.D_LZ = traced("D_LZ", MinerRule::liu_zenner, "slope (k + 3.6)/2, Liu and Zenner, not checked against the source");
  r.D = in.miner == MinerRule::original     ? NAMED_STEP("D", r.D_original, "the original rule decides")
        : in.miner == MinerRule::elementary ? NAMED_STEP("D", r.D_elementary, "the elementary rule decides")
        : in.miner == MinerRule::consistent ? NAMED_STEP("D", r.D_consistent, "the consistent rule decides")
        : in.miner == MinerRule::liu_zenner ? NAMED_STEP("D", r.D_LZ, "Liu and Zenner decide")
                                            : NAMED_STEP("D", r.D_modified, "the modified rule decides");
}

/// Effect neglected by the original rule: one cycle above the limit lowers it, and smaller ones count.
template <class Tracer>
void left_out(const Input& in, Result& r, Tracer& trace) {
  if (!History::is_of_part(in) || in.miner != MinerRule::original || !(r.D_original > 0.0)) return;
  STEP_TO(r, x_O, max(1.0 - r.D_original / r.D_modified, 0.0),
          "effect of cycles below the fatigue limit, [Haibach]: decreasing limit");
}

/// The cycle that does most, written out, and the life of the largest one.
template <class Tracer>
void largest_cycle(const Input& in, const Weights& w, Result& r, Tracer& trace) {
  const Cycle& worst = w.weighed.worst.front().cycle;
  r.S_1 = on_curve(in, haigh_of(in), worst, trace);
  r.sigma_a1 = in.K_A * amplitude_of(worst), r.sigma_mean = in.K_A * mean_of(worst);
  const auto N = w.curve.cycles(r.S_1 / MPa);
  r.N_S1 = N ? trace.value("N_S1", *N, "cycles on the curve, not reversals") : endless;
  if (const auto least = w.curve.cycles(w.weighed.largest))
    r.x_N = trace.value("x_N", *least, "life at the largest cycle only");
}

/// Damage below the omission level, by the curve of a single cycle.
template <class Tracer>
void gate(const Input& in, const HistoryDamage& weighed, Result& r, Tracer& trace) {
  if (!(in.gate > 0.0 * MPa)) return;
  const double left = weighed.small, kept = weighed.damage.front();
  r.x_g = trace.value("x_g", left > 0.0 ? left / (left + kept) : 0.0, "damage of what the gate leaves out");
}

template <class Tracer>
void life(const Input& in, Result& r, Tracer& trace) {
  if (r.D == 0.0) {
    r.Z = endless;
  } else {
    STEP_TO(r, Z, in.D_adm / r.D, "passages until the damage sum is the allowable one");
  }
  if (is_set(in.n_req)) {
    STEP_TO(r, u_D, in.n_req * r.D / in.D_adm, "damage of all passages, [Miner]");
  }
  const Time turn = time_of_turn(in);
  if (!is_set(in.t) && !is_set(turn)) return;
  const Time t_1 = trace.value("t_1", is_set(in.t) ? in.t : turn, is_set(in.t) ? "as given" : "one turn at its speed");
  if (r.D == 0.0) {
    r.L = from_si<Time>(endless);
  } else {
    STEP_TO(r, L, r.Z * t_1, "life");
  }
}

template <class Tracer>
void equivalent(const Input& in, const rainflow::SnCurve& curve, Result& r, Tracer& trace) {
  if (!is_set(in.N_eq) || !(r.D > 0.0)) return;
  const double passages = is_set(in.n_req) ? in.n_req : 1.0;
  const auto found = rainflow::equivalent_stress(curve, passages * r.D, in.N_eq);
  if (found) r.S_eq = trace.value("S_eq", *found * MPa, "on the curve where N_eq cycles do the damage of all passages");
}

template <class Tracer>
void yield(const Input& in, const Extremes& all, Result& r, Tracer& trace) {
  const Stress sigma_1 = trace.value("sigma_1", from_si<Stress>(all.largest), "maximum of the history");
  const Stress sigma_2 = trace.value("sigma_2", from_si<Stress>(all.least), "minimum of the history");
  STEP_TO(r, sigma_max, in.K_A * sigma_1, "with the application factor");
  STEP_TO(r, sigma_min, in.K_A * sigma_2, "with the application factor");
  if (!is_set(in.R_e)) return;
  STEP(sigma_y, in.stress == Stresses::shear ? in.R_e / sqrt(3.0) : in.R_e, "yield strength; of shear by [Mises]");
  STEP_TO(r, u_y, max(abs(sigma_max), abs(sigma_min)) / sigma_y, "first-cycle yielding");
  if (is_set(in.S_F)) {
    STEP_TO(r, u_F, in.S_F * u_y, "with the safety factor S_F");
  }
  if (in.curve == Curve::en1993) {
    STEP_TO(r, x_R, (sigma_max - sigma_min) / (1.5 * sigma_y), "ranges up to 1.5 f_y, [EN1993-1-9] 8 (1)");
  }
}

/// Whatever a cycle lasts on the curve, it lasts none beyond the strength of one. `largest`: amplitude on the curve of
/// a part, with its safety.
template <class Tracer>
void fracture(const Input& in, Stress largest, Result& r, Tracer& trace) {
  if (!is_set(in.R_m)) return;
  const Stress sigma_max = r.sigma_max, sigma_min = r.sigma_min;
  const Stress S_B = trace.value("S_B", haigh_of(in).R_m, "tensile strength, of shear in shear: that of one cycle");
  const Stress S_l = trace.value("S_l", largest, "maximum amplitude on the curve of a part");
  STEP(sigma_p, in.stress == Stresses::shear ? max(abs(sigma_max), abs(sigma_min)) : sigma_max,
       "maximum stress; for normal stresses the tensile one");
  STEP_TO(r, x_B, max(max(sigma_p, S_l), 0.0 * MPa) / S_B, "maximum stress / tensile strength");
}

}  // namespace

template <class Tracer>
History::Result History::evaluate(const Input& in, Tracer& trace) {
  Result r;
  yield(in, extremes_of(in), r, trace);
  const Weights w = weights_of(in);
  r.n = trace.value("n", w.weighed.cycles, in.blocks.empty() ? "cycles by rainflow" : "cycles of all blocks");
  classify(in, r);
  r.u_m = w.weighed.largest_mean;
  const bool left = !(r.u_m >= 1.0);  // by the mean stresses
  fracture(in, History::is_of_part(in) && left ? w.weighed.largest * MPa.one : 0.0 * MPa, r, trace);
  if (!left) return r;
  all_rules(in, w, r, trace);
  left_out(in, r, trace);
  if (!w.weighed.worst.empty()) largest_cycle(in, w, r, trace);
  write_worst(in, w.weighed, r);
  gate(in, w.weighed, r, trace);
  life(in, r, trace);
  equivalent(in, w.curve, r, trace);
  return r;
}

template History::Result History::evaluate(const Input&, NoTrace&);
template History::Result History::evaluate(const Input&, Trace&);

std::vector<figure::Figure> History::figures(const Input& in, const Result& r) {
  std::vector<figure::Figure> figures = class_figures(r);
  if (!(r.n > 0.0) || r.u_m >= 1.0) return figures;
  const std::vector<Cycle> cycles = cycles_of(in);
  const Haigh haigh = haigh_of(in);
  NoTrace quiet;
  std::vector<double> stress;
  stress.reserve(cycles.size());
  for (const Cycle& cycle : cycles) stress.push_back(on_curve(in, haigh, cycle, quiet) / MPa);
  const double largest = *std::ranges::max_element(stress);
  for (figure::Figure& figure :
       spectrum_figure(cycles, stress, curve_by(weighing_rule(in), in, largest), is_set(in.n_req) ? in.n_req : 1.0,
                       is_of_part(in) ? "equivalent amplitude" : "range"))
    figures.push_back(std::move(figure));
  return figures;
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::History>();
