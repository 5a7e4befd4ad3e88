#include "lib/project/run/compared.hpp"

#include "lib/formula/tree.hpp"
#include "lib/project/run/derivation.hpp"

#include <cmath>
#include <vector>

namespace loadpath::project {

namespace {

/// The unit of a side of a fraction that is one symbol; empty where it is not.
std::string unit_of_side(const formula::Node& side, const std::string& scope, const Names& names) {
  if (side.kind != formula::Kind::symbol) return {};
  const auto known = names.find(scope, side.text);
  return known ? known->unit : std::string();
}

/// Nothing where the formula is not one value over another, or its numbers are those of another position.
std::optional<account::Compared> compared_in(const Line& line, const Names& names, double utilisation) {
  constexpr double rounding = 5e-3;  // rounding of a peak between two positions
  constexpr int digits = 4;
  const auto tree = formula::parse(line.formula);
  if (!tree) return std::nullopt;
  const formula::Known known = [&](std::string_view name) { return names.si_of(line.scope, name); };
  const formula::Node& ratio = formula::chosen(*tree, known);
  if (ratio.kind != formula::Kind::binary || ratio.text != "/") return std::nullopt;
  std::string unit = unit_of_side(ratio.kids[1], line.scope, names);
  if (unit.empty()) unit = unit_of_side(ratio.kids[0], line.scope, names);
  const double demand = formula::value(ratio.kids[0], known), capacity = formula::value(ratio.kids[1], known);
  const bool agrees = std::abs(demand / capacity - utilisation) <= rounding * std::abs(utilisation);
  if (unit.empty() || !agrees) return std::nullopt;
  return account::Compared{{demand, unit, digits}, {capacity, unit, digits}};
}

/// Whether a limit that is a criterion is not kept: the values behind it say by how much.
bool is_failing(const ResultSeries& series) {
  const FieldInfo& field = *series.field;
  return field.role == Role::limit && field.is_criterion && !field.bounds.holds(series.value.si[0]);
}

}  // namespace

std::map<std::size_t, Checks> checks_by_position(const Evaluation& evaluation, const Results& results) {
  std::map<std::size_t, Checks> all;
  for (const ResultSeries& series : results.series) {
    if (series.value.si.empty() || !is_reported(evaluation, series)) continue;
    const bool is_single = evaluation.axis() == nullptr || !series.value.is_series();
    if (series.field->role != Role::check && !(is_single && is_failing(series))) continue;
    const Extreme most = is_single ? Extreme{series.value.si[0], 0.0, 0} : maximum(series.value);
    if (!std::isnan(most.value)) all[most.nearest][series.path] = most.value;
  }
  return all;
}

void add_compared(const Trace& trace, const Evaluation& evaluation, const Checks& checks, ComparedValues& compared) {
  Names names(evaluation.record(), evaluation.result());
  for (const Line& line : trace.lines()) {
    const std::string path = line.scope.empty() ? line.symbol : line.scope + "." + line.symbol;
    const auto check = checks.find(path);
    if (check != checks.end()) {
      if (const auto both = compared_in(line, names, check->second)) compared.insert_or_assign(path, *both);
    }
    names.add(line, names.unit_of(line));
  }
}

}  // namespace loadpath::project
