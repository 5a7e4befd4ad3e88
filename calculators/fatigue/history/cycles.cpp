#include "calculators/fatigue/history/cycles.hpp"

#include "lib/rainflow/counter.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace loadpath::fatigue {

namespace {

using Input = HistoryTypes::Input;
using Counting = HistoryTypes::Counting;
using Residue = HistoryTypes::Residue;

rainflow::Rules rules_of(const Input& in, bool placed) {
  rainflow::Rules rules;
  rules.method = in.counting == Counting::astm  ? rainflow::Method::astm
                 : in.counting == Counting::hcm ? rainflow::Method::hcm
                                                : rainflow::Method::four_point;
  const bool halves = in.residue == Residue::half_cycles;
  rules.residue = !halves                         ? rainflow::Residue::ignore
                  : in.counting == Counting::astm ? rainflow::Residue::astm
                                                  : rainflow::Residue::half_cycles;
  rules.placed = placed;
  return rules;
}

}  // namespace

void count_into(const Input& in, rainflow::Consumer& consumer, bool placed) {
  const std::vector<double>& samples = in.sigma.series->si;
  const rainflow::Rules rules = rules_of(in, placed);
  if (in.residue == Residue::repeated) {
    rainflow::count_periodic(samples, rules, consumer);
    return;
  }
  rainflow::Counter counter(rules, consumer);
  if (!counter.feed(samples)) counter.finish();
}

std::vector<rainflow::Cycle> cycles_of_blocks(const Input& in) {
  std::vector<rainflow::Cycle> cycles;
  cycles.reserve(in.blocks.size());
  for (const auto& block : in.blocks) cycles.push_back({2.0 * in_si(block.sigma_a), in_si(block.sigma_m), block.n, {}});
  return cycles;
}

std::vector<rainflow::Cycle> cycles_of(const Input& in) {
  if (!in.sigma.is_series()) return cycles_of_blocks(in);
  rainflow::CycleList list;
  count_into(in, list, false);
  std::vector<rainflow::Cycle> cycles = list.cycles();
  std::erase_if(cycles, [&](const rainflow::Cycle& cycle) { return cycle.range < in_si(in.gate); });
  return cycles;
}

Extremes extremes_of(const Input& in) {
  Extremes of;
  if (!in.blocks.empty()) {
    of = {-HUGE_VAL, HUGE_VAL};
    for (const auto& block : in.blocks) {
      of.largest = std::max(of.largest, in_si(block.sigma_m + block.sigma_a));
      of.least = std::min(of.least, in_si(block.sigma_m - block.sigma_a));
    }
  } else if (is_turn(in)) {  // they may lie between two positions
    of = {maximum(*in.sigma.series).value, minimum(*in.sigma.series).value};
  } else if (in.sigma.is_series()) {
    const auto [least, largest] = std::minmax_element(in.sigma.series->si.begin(), in.sigma.series->si.end());
    of = {*largest, *least};
  }
  return of;
}

bool is_turn(const Input& in) { return in.sigma.is_series() && in.sigma.series->signature.axis->cyclic(); }

Time time_of_turn(const Input& in) {
  if (!is_turn(in)) return unset<Time>;
  const Axis& axis = *in.sigma.series->signature.axis;
  if (axis.speed != 0.0) return from_si<Time>(std::abs(axis.period / axis.speed));
  return axis.unit == "s" ? from_si<Time>(std::abs(axis.period)) : unset<Time>;
}

}  // namespace loadpath::fatigue
