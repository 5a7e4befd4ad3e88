#include "lib/export/sweep/searches.hpp"

#include "lib/export/json_writer.hpp"
#include "lib/export/sweep/json_values.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::exports {

namespace {

using project::SweptInput;

/// The SI unit of a result that is shown in this unit.
std::string si_of_shown(const std::string& unit) {
  const auto parsed = parse_unit(unit);
  return parsed ? si_of(parsed->dimension) : "1";
}

void write_input(JsonWriter& json, const SweptInput& input) {
  json.member("input", input.name);
  if (input.words.empty()) json.member("unit", si_of(input.dimension));
}

JsonWriter begun(const project::Project& project) {
  JsonWriter json;
  json.open_object();
  json.member("project", project.file);
  return json;
}

std::string finished(JsonWriter& json) {
  json.close_object();
  return json.take();
}

const char* outcome_of(const sweep::Neighbour& neighbour) {
  using Outcome = sweep::Neighbour::Outcome;
  switch (neighbour.outcome) {
    case Outcome::breaks:
      return "violates a constraint";
    case Outcome::no_better:
      return "no better";
    case Outcome::better:
      return "better, not reached";
  }
  return "";
}

void write_neighbours(JsonWriter& json, const project::Best& best) {
  json.key("neighbours").open_array();
  for (std::size_t i = 0; i < best.optimum.neighbours.size(); ++i) {
    const sweep::Neighbour& neighbour = best.optimum.neighbours[i];
    const SweptInput& input = best.inputs[best.chosen[neighbour.variable]];
    json.open_object();
    write_input(json, input);
    json.key("value"), write_value(json, input, neighbour.point[neighbour.variable]);
    json.member("objective", neighbour.outputs[0]);
    json.member("outcome", outcome_of(neighbour));
    if (neighbour.broken < best.demands.size()) {
      json.member("constraint", best.demands[neighbour.broken].text);
      json.member("utilisation", neighbour.outputs[neighbour.broken + 1]);
    }
    if (!best.reasons[i].empty()) json.member("reason", best.reasons[i].text());
    json.close_object();
  }
  json.close_array();
}

const char* kind_of(const sweep::Solution& solution) {
  using Kind = sweep::Solution::Kind;
  switch (solution.kind) {
    case Kind::crossing:
      return "crossing";
    case Kind::touching:
      return "touching";
    case Kind::stretch:
      return "stretch";
    case Kind::leap:
      return "leap";
  }
  return "";
}

void write_tornado(JsonWriter& json, const project::Influence& influence, std::size_t k) {
  json.key("inputs").open_array();
  for (const sweep::Bar& bar : influence.tornados[k].bars) {
    json.open_object();
    write_input(json, influence.inputs[bar.input]);
    json.member("low", influence.low[bar.input]);
    json.member("high", influence.high[bar.input]);
    json.member("result_low", bar.low);
    json.member("result_high", bar.high);
    json.member("swing", bar.swing);
    json.member("slope", influence.slopes.at(k, bar.input).value);
    json.member("elasticity", influence.slopes.at(k, bar.input).elasticity);
    json.close_object();
  }
  json.close_array();
}

void write_budget(JsonWriter& json, const project::Influence& influence, const sweep::Budget& budget) {
  json.key("scatter").open_object();
  json.member("sd", std::sqrt(budget.variance));
  json.key("shares").open_array();
  for (const sweep::BudgetLine& line : budget.lines) {
    if (!influence.inputs[line.input].distribution) continue;
    json.open_object();
    json.member("input", influence.inputs[line.input].name);
    json.member("share", line.share);
    json.member("sd_at_half_its_scatter", std::sqrt(line.variance));
    json.close_object();
  }
  json.close_array();
  json.close_object();
}

void write_sobol(JsonWriter& json, const project::Influence& influence, const sweep::SobolIndices& indices) {
  json.key("sobol").open_array();
  for (std::size_t i = 0; i < indices.inputs.size(); ++i) {
    const sweep::SobolIndex& index = indices.inputs[i];
    json.open_object();
    json.member("input", influence.inputs[influence.scattering[i]].name);
    json.member("first", index.first);
    json.member("first_within", index.first_within);
    json.member("total", index.total);
    json.member("total_within", index.total_within);
    json.close_object();
  }
  json.close_array();
}

}  // namespace

std::string json_of(const project::Project& project, const project::Best& best) {
  JsonWriter json = begun(project);
  const sweep::Optimum& optimum = best.optimum;
  json.member("objective", best.objective);
  json.member("unit", si_of_shown(best.unit));
  json.member("value", optimum.outputs[0]);
  json.member("satisfies_constraints", optimum.allowed);
  if (!optimum.allowed && optimum.worst < best.demands.size())
    json.member("violated", best.demands[optimum.worst].text);
  if (!best.reason.empty()) json.member("reason", best.reason.text());
  if (!best.fails.empty()) json.member("fails", best.fails.text());
  json.member("designs", static_cast<std::int64_t>(optimum.candidates > 0 ? optimum.candidates : optimum.evaluations));
  json.member("all_designs", optimum.scope == sweep::Optimum::Scope::every_point && !optimum.budget_spent);
  json.key("selected").open_array();
  for (const std::size_t i : best.chosen) {
    json.open_object();
    write_input(json, best.inputs[i]);
    json.key("value"), write_value(json, best.inputs[i], best.point[i]);
    json.close_object();
  }
  json.close_array();
  write_neighbours(json, best);
  return finished(json);
}

std::string json_of(const project::Project& project, const project::SoughtValue& sought) {
  JsonWriter json = begun(project);
  write_input(json, sought.input);
  json.member("target", sought.target);
  json.member("target_unit", si_of_shown(sought.unit));
  json.key("meetings").open_array();
  for (const sweep::Solution& solution : sought.sought.solutions) {
    json.open_object();
    json.member("value", solution.at);
    if (solution.kind == sweep::Solution::Kind::stretch) json.member("to", solution.to);
    json.member("result", solution.value);
    json.member("kind", kind_of(solution));
    json.member("within", solution.within);
    json.close_object();
  }
  json.close_array();
  if (sought.sought.solutions.empty()) {
    json.member("nearest", sought.sought.nearest);
    json.member("result_there", sought.sought.value);
  }
  return finished(json);
}

std::string json_of(const project::Project& project, const project::Influence& influence) {
  JsonWriter json = begun(project);
  json.key("results").open_array();
  for (std::size_t k = 0; k < influence.names.size(); ++k) {
    json.open_object();
    json.member("name", influence.names[k]);
    json.member("unit", si_of_shown(influence.units[k]));
    json.member("middle", influence.tornados[k].base);
    write_tornado(json, influence, k);
    const bool scatters = !influence.budgets.empty() && influence.budgets[k].variance > 0.0;
    if (scatters) write_budget(json, influence, influence.budgets[k]);
    if (scatters && !influence.sobol.empty()) write_sobol(json, influence, influence.sobol[k]);
    json.close_object();
  }
  json.close_array();
  return finished(json);
}

}  // namespace loadpath::exports
