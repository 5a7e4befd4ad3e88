#include "calculators/fatigue/history/history.hpp"

#include "calculators/fatigue/history/classes.hpp"
#include "calculators/fatigue/history/curve.hpp"
#include "calculators/fatigue/history/cycles.hpp"
#include "calculators/fatigue/history/figure.hpp"
#include "calculators/fatigue/history/means.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/rainflow/damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace loadpath::fatigue {

namespace {

using Input = History::Input;
using Result = History::Result;
using Curve = History::Curve;
using MinerRule = History::MinerRule;
using rainflow::Cycle;

constexpr double endless = std::numeric_limits<double>::infinity();

Stress amplitude_of(const Cycle& cycle) { return from_si<Stress>(cycle.range / 2.0); }
Stress mean_of(const Cycle& cycle) { return from_si<Stress>(cycle.mean); }

/// The stress of a cycle on the curve: amplitude at r = -1, or range, with its factors. Shear has no sign; compression
/// counts as no mean stress, but by FKM.
template <class Tracer>
Stress on_curve(const Input& in, const Haigh& haigh, const Cycle& cycle, Tracer& trace) {
  const Stress sigma_a0 = trace.value("sigma_a0", amplitude_of(cycle), "amplitude, as counted");
  const Stress sigma_m0 = trace.value("sigma_m0", mean_of(cycle), "mean stress, as counted");
  STEP(sigma_a, in.K_A * sigma_a0, "with the application factor");
  if (!History::is_of_part(in)) return NAMED_STEP("S_1", 2.0 * in.S_D * sigma_a, "range, with the safety on stress");
  if (!counts_means(in) || sigma_a == 0.0 * MPa)
    return NAMED_STEP("S_1", in.S_D * sigma_a, "with the safety on stress; its mean is not counted");
  STEP(sigma_s, in.stress == Stresses::shear ? in.K_A * abs(sigma_m0) : in.K_A * sigma_m0,
       "with the application factor; of shear its magnitude");
  STEP(sigma_m, in.mean == History::Means::fkm ? sigma_s : max(sigma_s, 0.0 * MPa),
       "the benefit of compression is considered by FKM only");
  if (in.stress == Stresses::shear && is_set(haigh.R_m)) trace.value("R_m", haigh.R_m, "of shear, [Shigley6] (6-54)");
  if (in.stress == Stresses::shear && is_set(haigh.R_e)) trace.value("R_e", haigh.R_e, "of shear, [Mises]");
  const Stress sigma_ar = equivalent(rule_of(in), haigh, {sigma_a, sigma_m}, trace);
  return NAMED_STEP("S_1", in.S_D * sigma_ar, "amplitude at r = -1, with the safety on stress");
}

/// The largest mean stress over the strength that its rule ends at; where it is 1 or more nothing is left to vary.
/// Unset where the rule has no end.
double largest_mean(const Input& in, const Collective& all) {
  const Stress end = counts_means(in) ? fatigue::largest_mean(haigh_of(in), rule_of(in)) : unset<Stress>;
  if (!is_set(end)) return unset<double>;
  double most = 0.0;
  for (const auto* const cycles : {&all.cycles, &all.small}) {
    for (const Cycle& cycle : *cycles) {
      const Stress mean = in.K_A * mean_of(cycle);
      most = std::max(most, reduced((in.stress == Stresses::shear ? abs(mean) : mean) / end));
    }
  }
  return most;
}

/// Each cycle as a point of the curve, MPa.
struct OnCurve {
  std::vector<double> stress;
  double largest = 0.0;
};
OnCurve on_curve(const Input& in, const std::vector<Cycle>& cycles) {
  const Haigh haigh = haigh_of(in);
  NoTrace quiet;
  OnCurve all;
  all.stress.reserve(cycles.size());
  for (const Cycle& cycle : cycles) all.stress.push_back(on_curve(in, haigh, cycle, quiet) / MPa);
  for (const double s : all.stress) all.largest = std::max(all.largest, s);
  return all;
}

double damage_by(MinerRule rule, const Input& in, const std::vector<Cycle>& cycles, const OnCurve& on) {
  if (rule == MinerRule::consistent) {
    std::vector<rainflow::Level> levels;
    for (std::size_t i = 0; i < cycles.size(); ++i) levels.push_back({on.stress[i], cycles[i].count});
    const auto found = rainflow::consistent_damage(curve_of(in), std::move(levels));
    return found ? *found : unset<double>;
  }
  const rainflow::SnCurve curve = curve_by(rule, in, on.largest);
  double sum = 0.0;
  for (std::size_t i = 0; i < cycles.size(); ++i) sum += cycles[i].count * curve.damage(on.stress[i]);
  return sum;
}

/// The curve that one cycle is weighed with: of the consistent rule, which has none, that of Haibach.
rainflow::SnCurve weighing_curve(const Input& in, double largest) {
  return curve_by(in.miner == MinerRule::consistent ? MinerRule::modified : in.miner, in, largest);
}

/// The places of cycles that do most damage, the worst first; without damage the largest.
std::vector<std::size_t> worst_of(const Input& in, const std::vector<Cycle>& cycles, const OnCurve& on) {
  const rainflow::SnCurve curve = weighing_curve(in, on.largest);
  const auto weight = [&](std::size_t i) {
    const double damage = cycles[i].count * curve.damage(on.stress[i]);
    return std::pair(damage, on.stress[i]);
  };
  std::vector<std::size_t> places(cycles.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const auto end = places.begin() + static_cast<std::ptrdiff_t>(std::min(places.size(), History::most_worst));
  std::partial_sort(places.begin(), end, places.end(), [&](std::size_t a, std::size_t b) {
    return weight(a) != weight(b) ? weight(a) > weight(b) : a < b;
  });
  places.erase(end, places.end());
  return places;
}

/// Sample of a file, position of a turn.
double place_of(const Input& in, std::uint64_t index) {
  const auto place = static_cast<std::size_t>(index);
  if (!in.sigma.is_series() || is_turn(in)) return static_cast<double>(place);
  const auto& at = in.sigma.series->signature.axis->at;
  return place < at.size() ? at[place] : unset<double>;
}

void tell_worst(const Input& in, const std::vector<Cycle>& cycles, const OnCurve& on,
                const std::vector<std::size_t>& places, Result& r) {
  const rainflow::SnCurve curve = weighing_curve(in, on.largest);
  double all = 0.0;
  for (std::size_t i = 0; i < cycles.size(); ++i) all += cycles[i].count * curve.damage(on.stress[i]);
  for (const std::size_t i : places) {
    const Cycle& c = cycles[i];
    const double share = all > 0.0 ? c.count * curve.damage(on.stress[i]) / all : unset<double>;
    const bool placed = in.blocks.empty();
    r.worst.push_back({in.K_A * amplitude_of(c), in.K_A * mean_of(c), c.count, share,
                       placed ? place_of(in, c.where.begin) : unset<double>,
                       placed ? place_of(in, c.where.end) : unset<double>});
  }
}

template <class Tracer>
void all_rules(const Input& in, const std::vector<Cycle>& cycles, const OnCurve& on, Result& r, Tracer& trace) {
  const auto by = [&](MinerRule rule) { return damage_by(rule, in, cycles, on); };
  if (!History::is_of_part(in)) {
    r.D = trace.value("D", by(MinerRule::original), "sum of n / N over the cycles, [Miner]");
    return;
  }
  r.D_original = trace.value("D_original", by(MinerRule::original), "sum of n / N above the limit, [Miner]");
  r.D_elementary = trace.value("D_elementary", by(MinerRule::elementary), "the slope k for all cycles");
  r.D_modified = trace.value("D_modified", by(MinerRule::modified), "2 k - 1 below the limit, [Haibach]");
  r.D_consistent =
      trace.value("D_consistent", by(MinerRule::consistent), "decreasing fatigue limit, [Haibach], from memory");
  r.D_LZ = trace.value("D_LZ", by(MinerRule::liu_zenner), "slope (k + 3.6)/2, Liu and Zenner, from memory");
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
void largest_cycle(const Input& in, const std::vector<Cycle>& cycles, const OnCurve& on, std::size_t worst, Result& r,
                   Tracer& trace) {
  r.S_1 = on_curve(in, haigh_of(in), cycles[worst], trace);
  r.sigma_a1 = in.K_A * amplitude_of(cycles[worst]), r.sigma_m1 = in.K_A * mean_of(cycles[worst]);
  const rainflow::SnCurve curve = weighing_curve(in, on.largest);
  const auto N = curve.cycles(r.S_1 / MPa);
  r.N_S1 = N ? trace.value("N_S1", *N, "cycles on the curve, not reversals") : endless;
  if (const auto least = curve.cycles(on.largest)) r.x_N = trace.value("x_N", *least, "life at the largest cycle only");
}

/// Damage below the omission level, by the curve of a single cycle.
template <class Tracer>
void gate(const Input& in, const Collective& all, const OnCurve& on, Result& r, Tracer& trace) {
  if (!(in.gate > 0.0 * MPa)) return;
  const rainflow::SnCurve curve = weighing_curve(in, on.largest);
  const OnCurve small = on_curve(in, all.small);
  double kept = 0.0, left = 0.0;
  for (std::size_t i = 0; i < on.stress.size(); ++i) kept += all.cycles[i].count * curve.damage(on.stress[i]);
  for (std::size_t i = 0; i < small.stress.size(); ++i) left += all.small[i].count * curve.damage(small.stress[i]);
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
void equivalent(const Input& in, const OnCurve& on, Result& r, Tracer& trace) {
  if (!is_set(in.N_eq) || !(r.D > 0.0)) return;
  const double passages = is_set(in.n_req) ? in.n_req : 1.0;
  const auto found = rainflow::equivalent_stress(weighing_curve(in, on.largest), passages * r.D, in.N_eq);
  if (found) r.S_eq = trace.value("S_eq", *found * MPa, "on the curve where N_eq cycles do the damage of all passages");
}

template <class Tracer>
void yield(const Input& in, const Collective& all, Result& r, Tracer& trace) {
  const Stress sigma_1 = trace.value("sigma_1", from_si<Stress>(all.largest), "maximum of the history");
  const Stress sigma_2 = trace.value("sigma_2", from_si<Stress>(all.least), "minimum of the history");
  STEP_TO(r, sigma_max, in.K_A * sigma_1, "with the application factor");
  STEP_TO(r, sigma_min, in.K_A * sigma_2, "with the application factor");
  if (!is_set(in.R_e)) return;
  STEP(sigma_y, in.stress == Stresses::shear ? in.R_e / sqrt(3.0) : in.R_e, "yield strength; of shear by [Mises]");
  STEP_TO(r, u_y, max(abs(sigma_max), abs(sigma_min)) / sigma_y, "first-cycle yielding");
  if (is_set(in.S_F)) {
    STEP_TO(r, u_F, in.S_F * u_y, "with its safety");
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
  const Collective all = collective_of(in);
  yield(in, all, r, trace);
  double n = 0.0;
  for (const Cycle& cycle : all.cycles) n += cycle.count;
  r.n = trace.value("n", n, in.blocks.empty() ? "cycles by rainflow" : "cycles of all blocks");
  classify(in, r);
  r.u_m = largest_mean(in, all);
  const bool left = !(r.u_m >= 1.0);  // by the mean stresses
  const OnCurve on = left ? on_curve(in, all.cycles) : OnCurve{};
  fracture(in, History::is_of_part(in) ? on.largest * MPa.one : 0.0 * MPa, r, trace);
  if (!left) return r;
  all_rules(in, all.cycles, on, r, trace);
  left_out(in, r, trace);
  const auto worst = worst_of(in, all.cycles, on);
  if (!worst.empty()) largest_cycle(in, all.cycles, on, worst.front(), r, trace);
  tell_worst(in, all.cycles, on, worst, r);
  gate(in, all, on, r, trace);
  life(in, r, trace);
  equivalent(in, on, r, trace);
  return r;
}

template History::Result History::evaluate(const Input&, NoTrace&);
template History::Result History::evaluate(const Input&, Trace&);

std::vector<figure::Figure> History::figures(const Input& in, const Result& r) {
  const Collective all = collective_of(in);
  std::vector<figure::Figure> figures = class_figures(r);
  if (all.cycles.empty() || largest_mean(in, all) >= 1.0) return figures;
  const OnCurve on = on_curve(in, all.cycles);
  for (figure::Figure& figure :
       collective_figure(all.cycles, on.stress, weighing_curve(in, on.largest), is_set(in.n_req) ? in.n_req : 1.0,
                         is_of_part(in) ? "amplitude at r = -1" : "range"))
    figures.push_back(std::move(figure));
  return figures;
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::History>();
