#include "lib/project/run/calculator_step.hpp"

#include "lib/project/run/account.hpp"
#include "lib/project/run/evaluation/left_loads.hpp"
#include "lib/project/run/input_effects.hpp"
#include "lib/table/tables.hpp"

#include <cmath>

namespace loadpath::project {

void CalculatorStep::solve(const Known& known, const Wanted& wanted, std::vector<Issue>& issues) {
  Evaluation evaluation(*this, known);
  Inputs& inputs = evaluation.inputs();
  if (!inputs.take_from_others(issues) || !inputs.evaluate_operands(issues)) return;
  loads().left = left_loads(*this, inputs, known);
  if (!refuse_other_parts(evaluation, known, issues) || !evaluation.check_rules(issues)) return;
  if (!run_search(evaluation, wanted.words, issues, together_ ? &*together_ : nullptr)) return;
  Findings found{.results = evaluate_all(evaluation, wanted.words)};
  found.weighed = weigh_typed_values(evaluation, found.results, known, wanted, issues);
  found.governing = evaluate_governing(evaluation, found.results, wanted.words);
  if (wanted.unused && wanted.warnings) warn_of_unused(evaluation, found.results, found.governing, issues);
  fill_account(evaluation, found, wanted, own_account());
  const WeighedValues& weighed = found.weighed;
  compared_ = weighed.compared;
  kept_bounds_ = weighed.bounds;
  goes_point_by_point_ = weighed.holds_back || (weighed.compared_by_size &&
                                                !(input().reading.varied.empty() && input().reading.operands.empty()));
  for (const auto& [group, row] : inputs.rows()) name_row(group, row.text);
}

void CalculatorStep::solve_without(const std::set<std::string>& inputs, const Known& known) {
  Evaluation evaluation(*this, known);
  std::vector<Issue> reported;  // again by the complete solution
  if (!evaluation.inputs().take_from_others(reported) || !evaluation.inputs().evaluate_operands(reported, inputs))
    return;
  Findings found{.results = evaluate_all(evaluation)};
  found.governing = evaluate_governing(evaluation, found.results, false);
  fill_account(evaluation, found, {.pictures = false, .formulas = false, .unused = false, .words = false},
               own_account());
}

std::vector<RowOfSearch> CalculatorStep::rows_of_search(const std::vector<std::string>& of) const {
  const Search& search = searches().front();
  std::vector<RowOfSearch> all;
  const auto rows = input().tables->ordered_rows(search.path, search.stock, search.where);
  for (const table::Entry& entry : *rows) {  // its text has been checked
    RowOfSearch row{entry.row->name, table::property(entry, table::order_of(search.path))->si, {}};
    for (const std::string& key : of) {
      const auto value = table::property(entry, find_field(input().calculator->input->fields, key)->provider.column);
      row.given.push_back(value ? value->si : std::nan(""));
    }
    all.push_back(std::move(row));
  }
  return all;
}

std::vector<std::size_t> CalculatorStep::first_rows_that_pass(const Known& known,
                                                              std::span<const std::size_t> alike) const {
  Evaluation evaluation(*this, known);
  std::vector<Issue> reported;  // by the complete solution
  if (!evaluation.inputs().take_from_others(reported) || !evaluation.inputs().evaluate_operands(reported))
    return std::vector<std::size_t>(alike.size(), alike.size());
  return project::first_rows_that_pass(evaluation, alike);
}

std::unique_ptr<Step> make_calculator_step(StepInput&& input) {
  return std::make_unique<CalculatorStep>(std::move(input));
}

}  // namespace loadpath::project
