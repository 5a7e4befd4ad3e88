// One pass over the cycles of a history, however long it is: their stresses on the curve, the damage by each rule, and
// the cycles that do most of it.
#pragma once

#include "calculators/fatigue/history/types.hpp"
#include "calculators/fatigue/mean_stress.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/rainflow/cycle.hpp"
#include "lib/rainflow/sn_curve.hpp"

#include <optional>
#include <span>
#include <vector>

namespace loadpath::fatigue {

inline Stress amplitude_of(const rainflow::Cycle& cycle) { return from_si<Stress>(cycle.range / 2.0); }
inline Stress mean_of(const rainflow::Cycle& cycle) { return from_si<Stress>(cycle.mean); }

/// The stress of a cycle on the curve: amplitude at r = -1, or range, with its factors. Shear has no sign; compression
/// counts as no mean stress, but by FKM.
template <class Tracer>
Stress on_curve(const HistoryTypes::Input& in, const Haigh& haigh, const rainflow::Cycle& cycle, Tracer& trace);

/// A cycle with its stress on the curve, MPa, and its damage by the curve that weighs, with its count.
struct DamagingCycle {
  rainflow::Cycle cycle;
  double stress = 0.0, damage = 0.0;
};

struct HistoryDamage {
  double cycles = 0.0;                  // halves as 0.5
  double largest = 0.0;                 // stress on the curve, MPa
  double largest_mean = unset<double>;  // over the strength that its rule ends at; unset where the rule has no end
  std::vector<double> damage;           // of each curve
  double small = 0.0;                   // damage of the cycles below the omission level, by the first curve
  std::vector<DamagingCycle> worst;     // by the first curve, the most damaging first; without damage the largest
  std::vector<rainflow::Level> levels;  // of every cycle, on request
};

/// The maximum stress on the curve, MPa: of a rule that depends on it.
double largest_on_curve(const HistoryTypes::Input& in);

/// `curves`: the first one weighs single cycles.
HistoryDamage weigh(const HistoryTypes::Input& in, std::span<const rainflow::SnCurve> curves, bool keeps_levels);

/// Whether a cycle has a mean stress in tension, or any in shear.
bool has_tensile_mean(const HistoryTypes::Input& in);

}  // namespace loadpath::fatigue
