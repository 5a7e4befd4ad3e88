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

rainflow::Rules rules_of(const Input& in) {
  rainflow::Rules rules;
  rules.method = in.counting == Counting::astm  ? rainflow::Method::astm
                 : in.counting == Counting::hcm ? rainflow::Method::hcm
                                                : rainflow::Method::four_point;
  const bool halves = in.residue == Residue::half_cycles;
  rules.residue = !halves                         ? rainflow::Residue::ignore
                  : in.counting == Counting::astm ? rainflow::Residue::astm
                                                  : rainflow::Residue::half_cycles;
  rules.placed = true;
  return rules;
}

std::vector<rainflow::Cycle> counted(const Input& in) {
  rainflow::CycleList list;
  count_into(in, list);
  return list.cycles();
}

Collective of_blocks(const Input& in) {
  Collective all;
  all.largest = -HUGE_VAL, all.least = HUGE_VAL;
  for (std::size_t i = 0; i < in.blocks.size(); ++i) {
    const auto& block = in.blocks[i];
    const double a = in_si(block.sigma_a), m = in_si(block.sigma_m);
    all.cycles.push_back({2.0 * a, m, block.n, {i, i}});
    all.largest = std::max(all.largest, m + a), all.least = std::min(all.least, m - a);
  }
  return all;
}

}  // namespace

void count_into(const Input& in, rainflow::Consumer& consumer) {
  const std::vector<double>& samples = in.sigma.series->si;
  const rainflow::Rules rules = rules_of(in);
  if (in.residue == Residue::repeated) {
    rainflow::count_periodic(samples, rules, consumer);
    return;
  }
  rainflow::Counter counter(rules, consumer);
  if (!counter.feed(samples)) counter.finish();
}

Collective collective_of(const Input& in) {
  if (!in.blocks.empty()) return of_blocks(in);
  if (!in.sigma.is_series()) return {};
  Collective all;
  for (rainflow::Cycle& cycle : counted(in)) (cycle.range < in_si(in.gate) ? all.small : all.cycles).push_back(cycle);
  if (const Value& series = *in.sigma.series; is_turn(in)) {  // its extremes may lie between two positions
    all.largest = maximum(series).value, all.least = minimum(series).value;
  } else {
    const auto [least, largest] = std::minmax_element(series.si.begin(), series.si.end());
    all.largest = *largest, all.least = *least;
  }
  return all;
}

bool is_turn(const Input& in) { return in.sigma.is_series() && in.sigma.series->signature.axis->cyclic(); }

Time time_of_turn(const Input& in) {
  if (!is_turn(in)) return unset<Time>;
  const Axis& axis = *in.sigma.series->signature.axis;
  if (axis.speed != 0.0) return from_si<Time>(std::abs(axis.period / axis.speed));
  return axis.unit == "s" ? from_si<Time>(std::abs(axis.period)) : unset<Time>;
}

}  // namespace loadpath::fatigue
