// Changes of the loaded flanks of teeth: the backlash is crossed there.
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace loadpath::planar {

namespace {

/// A crossing of zero between two positions, by halving on the series between them.
double crossing(const Value& series, double low, double high) {
  const bool rises = value_at(series, low) < 0.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    ((value_at(series, middle) < 0.0) == rises ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Sign changes of the circumferential force: the backlash is crossed there, with a knock.
std::string changes_of_flank(const Value& series, const Axis& axis) {
  const double negligible = 1e-9 * std::abs(largest(series).value);
  std::string places;
  std::optional<std::size_t> before;
  const auto look = [&](std::size_t k, double ahead) {
    const double here = series.si[k];
    if (std::isnan(here)) return before.reset();  // values in a gap are unknown
    if (std::abs(here) <= negligible) return;
    if (before && series.si[*before] * here < 0.0) {
      const double at = crossing(series, axis.at[*before], axis.at[k] + ahead);
      places += (places.empty() ? "" : ", ") + format_quantity(at, axis.unit, 5);
    }
    before = k;
  };
  for (std::size_t k = 0; k < series.si.size(); ++k) look(k, 0.0);
  const auto settles = [&](double x) { return !(std::abs(x) <= negligible); };
  const auto first = std::find_if(series.si.begin(), series.si.end(), settles);
  if (axis.cyclic() && first != series.si.end()) look(static_cast<std::size_t>(first - series.si.begin()), axis.period);
  return places;
}

/// Flank changes of gears and racks over a cycle.
void show_flanks(const Solved& solved, const Results& results, std::vector<account::Block>& blocks) {
  if (solved.axis == nullptr) return;
  account::Table table{say("Loaded flanks of teeth"), {say("joint"), say("the flank changes at")}, {}};
  for (const auto& line : results) {
    if (line.kind() != Kind::tooth_force) continue;
    const std::string places = changes_of_flank(line.entry->value, *solved.axis);
    table.rows.push_back({line.output->name, places.empty() ? account::Cell(say("nowhere")) : account::Cell(places)});
  }
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
}

}  // namespace

constinit const Aspect aspects::flanks{.show = &show_flanks};

}  // namespace loadpath::planar
