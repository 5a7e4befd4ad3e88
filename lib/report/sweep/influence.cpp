#include "lib/report/sweep/influence.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/sweep/shares.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {

namespace {

using project::Influence;

Quantity shown(double si, const std::string& unit) { return {si, unit.empty() ? std::string("-") : unit, 4}; }

/// A result that keeps its value nearby and has another at the ends, as a size of a stock has.
bool is_in_steps(const sweep::Slope& slope, double swing) {
  return slope.kind == sweep::Slope::Kind::smooth && slope.value == 0.0 && swing > 0.0;
}

const char* kind_of(const sweep::Slope& slope, double swing) {
  using Kind = sweep::Slope::Kind;
  switch (slope.kind) {
    case Kind::smooth:
      return is_in_steps(slope, swing) ? "in steps, no slope" : "";
    case Kind::kink:
      return "a kink";
    case Kind::below:
      return "from below only";
    case Kind::above:
      return "from above only";
    case Kind::unsettled:
      return "a leap, or noise";
    case Kind::none:
      return "not available";
  }
  return "";
}

/// The range of an input compared with the largest one.
std::string bar_of(double swing, double largest) {
  constexpr double longest = 12.0;
  if (std::isnan(swing) || !(largest > 0.0)) return "";
  std::string bar;
  for (int i = 0; i < static_cast<int>(std::lround(longest * swing / largest)); ++i) bar += "█";
  return bar;
}

double largest_swing(const sweep::Tornado& tornado) {
  double largest = 0.0;
  for (const sweep::Bar& bar : tornado.bars) largest = std::max(largest, std::isnan(bar.swing) ? 0.0 : bar.swing);
  return largest;
}

/// "4.2 to 5.1 mm"; "not available" for an end without a result.
std::string from_to(double low, double high, const std::string& unit) {
  const auto end = [&](double si) {
    return std::isnan(si) ? std::string("not available") : format_quantity(si, unit.empty() ? "-" : unit, 4);
  };
  return end(low) + " to " + end(high);
}

Table tornado_table(const Influence& influence, std::size_t k) {
  const sweep::Tornado& tornado = influence.tornados[k];
  const std::string& unit = influence.units[k];
  const double largest = largest_swing(tornado);
  Table table{say("{1}: each input by itself, low and high; {2} in the middle", influence.names[k],
                  format_quantity(tornado.base, unit.empty() ? "-" : unit, 4)),
              {say("input"), say("low to high"), say("result"), say("swing"), say("relative slope"), say("remark")},
              {}};
  for (const sweep::Bar& bar : tornado.bars) {
    const auto& input = influence.inputs[bar.input];
    const sweep::Slope& slope = influence.slopes.at(k, bar.input);
    table.rows.push_back({input.name,
                          written(input, influence.low[bar.input]) + " to " + written(input, influence.high[bar.input]),
                          from_to(bar.low, bar.high, unit), bar_of(bar.swing, largest),
                          std::isnan(slope.elasticity) ? Cell(std::string("-")) : Cell(shown(slope.elasticity, "-")),
                          std::string(kind_of(slope, bar.swing))});
  }
  return table;
}

Table budget_table(const Influence& influence, std::size_t k) {
  const sweep::Budget& budget = influence.budgets[k];
  const std::string unit = influence.units[k].empty() ? "-" : influence.units[k];
  const double sd = std::sqrt(budget.variance);
  bool certain = budget.certain;
  for (const sweep::Bar& bar : influence.tornados[k].bars) {
    const bool scatters = influence.inputs[bar.input].distribution.has_value();
    certain = certain && !(scatters && is_in_steps(influence.slopes.at(k, bar.input), bar.swing));
  }
  Table table{say("{1}: sources of scatter, standard deviation {2} by slopes{3}", influence.names[k],
                  format_quantity(sd, unit, 4), certain ? "" : "; some are not smooth, so it is a guess"),
              {say("input"), say("share of the variance"), say("remaining standard deviation at half its scatter")},
              {}};
  for (const sweep::BudgetLine& line : budget.lines) {
    if (!influence.inputs[line.input].distribution) continue;
    table.rows.push_back(
        {influence.inputs[line.input].name, in_percent(line.share), shown(std::sqrt(line.variance), unit)});
  }
  return table;
}

Table sobol_table(const Influence& influence, std::size_t k) {
  const sweep::SobolIndices& indices = influence.sobol[k];
  Table table{say("{1}: Sobol indices, {2} rows", influence.names[k], std::to_string(indices.rows)),
              {say("input"), say("alone"), say("within"), say("with all interactions"), say("within")},
              {}};
  for (std::size_t i = 0; i < indices.inputs.size(); ++i) {
    const sweep::SobolIndex& index = indices.inputs[i];
    table.rows.push_back({influence.inputs[influence.scattering[i]].name, in_percent(index.first),
                          "±" + in_percent(index.first_within), in_percent(index.total),
                          "±" + in_percent(index.total_within)});
  }
  return table;
}

/// A bar for each input, the longest on top: its result from low to high.
figure::Figure tornado_figure(const Influence& influence, std::size_t k) {
  const sweep::Tornado& tornado = influence.tornados[k];
  figure::Plot plot(figure::Scale{influence.names[k], "", influence.units[k]}, figure::Scale{"rank", "input", "-"});
  const auto count = static_cast<double>(tornado.bars.size());
  for (std::size_t b = 0; b < tornado.bars.size(); ++b) {
    const sweep::Bar& bar = tornado.bars[b];
    if (std::isnan(bar.swing)) continue;
    const double y = count - static_cast<double>(b);
    plot.curves.push_back({influence.inputs[bar.input].name, {bar.low, tornado.base, bar.high}, {y, y, y}, false});
  }
  return {"tornado-" + std::to_string(k + 1), "Each input separately, from low to high", std::move(plot)};
}

}  // namespace

std::vector<Block> influence_blocks(const Influence& influence) {
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < influence.names.size(); ++k) {
    blocks.emplace_back(tornado_table(influence, k));
    blocks.emplace_back(tornado_figure(influence, k));
    const bool scatters = !influence.budgets.empty() && influence.budgets[k].variance > 0.0;
    if (scatters) blocks.emplace_back(budget_table(influence, k));
    if (scatters && !influence.sobol.empty()) blocks.emplace_back(sobol_table(influence, k));
  }
  return blocks;
}

}  // namespace loadpath::report
