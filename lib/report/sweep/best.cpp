#include "lib/report/sweep/best.hpp"

#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::report {

namespace {

using project::Best;
using project::SweptInput;

Quantity in_unit_of(double si, const std::string& unit) { return {si, unit.empty() ? std::string("-") : unit, 5}; }

/// The reliability of the result.
Message reach_of(const sweep::Optimum& optimum) {
  using Scope = sweep::Optimum::Scope;
  const std::string n = std::to_string(optimum.candidates > 0 ? optimum.candidates : optimum.evaluations);
  if (optimum.budget_spent) return say("the search ended after {1} designs, before completion", n);
  if (optimum.scope == Scope::every_point) return say("the best of all {1} designs", n);
  if (optimum.scope == Scope::every_combination)
    return say("the best of every combination of the values, {1} designs", n);
  return say("better than all neighbouring designs and than the results from other starts; {1} designs", n);
}

Table chosen_table(const Best& best) {
  Table table{say("Selected values"), {say("input"), say("value"), say("source")}, {}};
  for (std::size_t i = 0; i < best.inputs.size(); ++i) {
    const SweptInput& input = best.inputs[i];
    const bool chosen = std::find(best.chosen.begin(), best.chosen.end(), i) != best.chosen.end();
    const Message from = !chosen              ? say("uncertain")
                         : input.distribution ? say("a range")
                                              : say("{1} values", std::to_string(input.axis.size()));
    table.rows.push_back({input.name, written(input, best.point[i]), from});
  }
  return table;
}

/// The reason why a neighbour of the best design is not better.
Message lot_of(const Best& best, const sweep::Neighbour& neighbour, const Message& reason) {
  using Outcome = sweep::Neighbour::Outcome;
  if (neighbour.outcome == Outcome::better) return say("better: the search ended before it");
  if (neighbour.outcome == Outcome::no_better) return say("no better");
  if (neighbour.broken >= best.demands.size()) return say("no nearer to the constraints");
  const std::string& demand = best.demands[neighbour.broken].text;
  const double value = neighbour.outputs[neighbour.broken + 1];
  if (best.quantile && best.demands[neighbour.broken].kind == sweep::Constraint::Kind::is_one && std::isfinite(value))
    return say("violates '{1}' in {2} % of the samples", demand,
               format_number(value * (1.0 - *best.quantile) * 100, 3));
  if (std::isfinite(value) && !reason.empty())
    return say("violates '{1}' ({2}): {3}", demand, format_number(value, 4), reason);
  if (std::isfinite(value)) return say("violates '{1}' ({2})", demand, format_number(value, 4));
  if (reason.empty()) return say("violates '{1}' ({2})", demand, say("not available"));
  return reason;
}

Table neighbour_table(const Best& best) {
  Table table{say("Neighbouring values"), {say("input"), say("value"), say("{1}", best.objective), say("why not")}, {}};
  for (std::size_t i = 0; i < best.optimum.neighbours.size(); ++i) {
    const sweep::Neighbour& neighbour = best.optimum.neighbours[i];
    const SweptInput& input = best.inputs[best.chosen[neighbour.variable]];
    table.rows.push_back({input.name, written(input, neighbour.point[neighbour.variable]),
                          in_unit_of(neighbour.outputs[0], best.unit), lot_of(best, neighbour, best.reasons[i])});
  }
  return table;
}

}  // namespace

namespace {

/// Fewer samples than the probability needs: what they show.
std::vector<Block> too_few_samples(const Best& best) {
  if (!best.quantile || best.samples == 0) return {};
  const double needed = project::samples_needed(*best.quantile);
  if (static_cast<double>(best.samples) >= needed) return {};
  const Message text =
      say("{1} samples show a probability of {2} % with 95 % confidence, and {3} % needs {4}: --samples {4}",
          std::to_string(best.samples), format_number(100.0 * project::shown_by(best.samples), 4),
          format_number(100.0 * *best.quantile, 7), format_number(needed, 12));
  return {Paragraph{text, Paragraph::Tone::warning}};
}

}  // namespace

std::vector<Block> best_blocks(const Best& best) {
  std::vector<Block> blocks;
  const sweep::Optimum& optimum = best.optimum;
  const std::string value = format_quantity(optimum.outputs[0], best.unit.empty() ? "-" : best.unit, 6);
  if (optimum.allowed) {
    blocks.emplace_back(
        Paragraph{say("{1} = {2}: {3}", best.objective, value, reach_of(optimum)), Paragraph::Tone::plain});
  } else {
    const std::string worst = optimum.worst < best.demands.size() ? best.demands[optimum.worst].text : best.objective;
    const Message broken = best.reason.empty() ? say("'{1}'", worst) : say("'{1}' ({2})", worst, best.reason);
    blocks.emplace_back(
        Paragraph{say("no design satisfies the constraints; the nearest violates {1}; {2}", broken, reach_of(optimum)),
                  Paragraph::Tone::warning});
  }
  if (!best.fails.empty()) {
    blocks.emplace_back(
        Paragraph{say("this design does not pass: {1}; add --such-that \"every mode passes\"", best.fails),
                  Paragraph::Tone::warning});
  }
  for (Block& warning : too_few_samples(best)) blocks.push_back(std::move(warning));
  blocks.emplace_back(chosen_table(best));
  blocks.emplace_back(neighbour_table(best));
  return blocks;
}

std::vector<Block> seek_blocks(const project::SoughtValue& sought) {
  using Kind = sweep::Solution::Kind;
  std::vector<Block> blocks;
  const auto shown = [&](double si) { return written(sought.input, si); };
  const std::string unit = sought.unit.empty() ? "-" : sought.unit;
  if (sought.sought.solutions.empty()) {
    blocks.emplace_back(Paragraph{std::isnan(sought.sought.nearest)
                                      ? say("no value of {1} has a result at all", sought.input.name)
                                      : say("no value of {1} gives {2}; {3} comes nearest, with {4}", sought.input.name,
                                            format_quantity(sought.target, unit, 6), shown(sought.sought.nearest),
                                            format_quantity(sought.sought.value, unit, 6)),
                                  Paragraph::Tone::warning});
    return blocks;
  }
  Table table{say("Solution"), {say("{1}", sought.input.name), say("result"), say("how")}, {}};
  for (const sweep::Solution& solution : sought.sought.solutions) {
    const Message how = solution.kind == Kind::crossing   ? say("crosses it")
                        : solution.kind == Kind::touching ? say("touches it")
                        : solution.kind == Kind::stretch  ? say("equals it up to {1}", shown(solution.to))
                                                          : say("jumps across it");
    table.rows.push_back({shown(solution.at), in_unit_of(solution.value, unit), how});
  }
  blocks.emplace_back(std::move(table));
  blocks.emplace_back(
      Paragraph{say("Only the result is solved for; whether the design passes there: `loadpath run FILE --set {1}=...`",
                    sought.input.name),
                Paragraph::Tone::plain});
  return blocks;
}

}  // namespace loadpath::report
