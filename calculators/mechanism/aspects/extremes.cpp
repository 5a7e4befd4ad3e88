// Largest and smallest of drives, reactions and what else parts are designed for, over the cycle; at one position the
// values.
#include "calculators/mechanism/results/aspect.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;

/// The mean, with what rounding has left of a zero taken as one.
double mean_of(const Value& series) {
  const double average = mean(series);
  const double rounding = std::max(series.rounding, 1e-12 * std::abs(largest(series).value));
  return std::abs(average) < rounding ? 0.0 : average;
}

/// A value of a result, or why it is missing.
Cell value_cell(const account::Entry& e, double si) {
  const bool is_missing = std::isnan(si) && !e.missing.empty();
  return is_missing ? Cell(say("not available: {1}", e.missing)) : Cell(Quantity{si, e.unit});
}

/// Results that are not unique have a table of their own.
Table extremes_table(const Results& results, const Cycle& cycle, const Axis& axis) {
  Table table{axis.cyclic() ? say("Extreme values over the cycle") : say("Extremes over the positions"),
              {say("quantity"), say("largest"), say("at"), say("smallest"), say("at")},
              {}};
  if (axis.cyclic()) table.head.insert(table.head.end(), {say("mean"), say("rms")});
  for (const auto& [output, entry] : results) {
    const account::Entry& e = *entry;
    if (output->what.facts.tabled != Tabled::always || !e.value.is_series() || is_constant(e.value)) continue;
    if (!cycle.unique.empty() && is_open(e)) continue;
    const Extreme high = maximum(e.value), low = minimum(e.value);
    std::vector<Cell> row{e.path, value_cell(e, high.value), Quantity{high.at, axis.unit}, Quantity{low.value, e.unit},
                          Quantity{low.at, axis.unit}};
    if (axis.cyclic())
      row.insert(row.end(), {Quantity{mean_of(e.value), e.unit}, Quantity{root_mean_square(e.value), e.unit}});
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Results without extremes.
std::optional<Table> constant_table(const Results& results, const Axis& axis) {
  Table table{axis.cyclic() ? say("Constants over the cycle") : say("Constant over the positions"),
              {say("quantity"), say("value"), say("meaning")},
              {}};
  for (const auto& [output, entry] : results) {
    const account::Entry& e = *entry;
    if (output->what.facts.tabled != Tabled::always || !e.value.is_series() || !is_constant(e.value)) continue;
    table.rows.push_back({e.path, Quantity{e.value.si.front(), e.unit}, say("{1}", e.doc)});
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

Table position_table(const Results& results) {
  Table table{say("Drive and reactions"), {say("quantity"), say("value"), say("meaning")}, {}};
  for (const auto& line : results) {
    if (line.facts().tabled == Tabled::no) continue;
    const account::Entry& e = *line.entry;
    table.rows.push_back({e.path, value_cell(e, e.value.si[0]), say("{1}", e.doc)});
  }
  return table;
}

void show_extremes(const Solved& solved, const Results& results, std::vector<account::Block>& blocks) {
  if (solved.axis == nullptr) {
    blocks.emplace_back(position_table(results));
    return;
  }
  blocks.emplace_back(extremes_table(results, solved.cycle, *solved.axis));
  if (auto constant = constant_table(results, *solved.axis)) blocks.emplace_back(std::move(*constant));
}

}  // namespace

constinit const Aspect aspects::extremes{.show = &show_extremes};

}  // namespace loadpath::planar
