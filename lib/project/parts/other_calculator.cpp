#include "lib/project/parts/other_calculator.hpp"

#include "lib/project/read/read_record.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

using toml::Tree;

/// The number of keys of a step that a calculator has as inputs.
std::ptrdiff_t count_known(const Tree& step, const Calculator& calculator) {
  return std::count_if(step.entries.begin(), step.entries.end(), [&](const Tree::Entry& entry) {
    return find_input(calculator.input->fields, entry.key) != nullptr;
  });
}

const Calculator* best_for(const Tree& step, Catalogue catalogue, std::ptrdiff_t more_than) {
  const Calculator* best = nullptr;
  for (const CatalogueEntry& entry : catalogue) {
    const std::ptrdiff_t known = count_known(step, *entry.calculator);
    if (known <= more_than) continue;
    more_than = known;
    best = entry.calculator;
  }
  return best;
}

}  // namespace

std::string calculator_with(const Tree& step, Catalogue catalogue) {
  const Calculator* const best = best_for(step, catalogue, 1);
  return best == nullptr ? "shaft.torsion" : best->id;
}

void name_calculator(const Tree& step, StepInput& input, Catalogue catalogue, std::size_t before,
                     std::vector<Issue>& issues) {
  constexpr std::ptrdiff_t several = 3;
  const std::string prefix = input.name + ".";
  const auto is_unknown = [&](const Issue& issue) {
    return issue.key_fault == KeyFault::unknown && issue.key.starts_with(prefix) &&
           step.find(issue.key.substr(prefix.size())) != nullptr;
  };
  const auto is_missing = [&](const Issue& issue) {
    return issue.key_fault == KeyFault::missing && issue.key.starts_with(prefix);
  };
  const auto begin = issues.begin() + static_cast<std::ptrdiff_t>(before);
  if (std::count_if(begin, issues.end(), is_unknown) < several) return;
  const std::ptrdiff_t own = count_known(step, *input.calculator);
  const Calculator* const better = best_for(step, catalogue, own + several - 1);
  const auto* const named = step.find("calculator");
  if (better == nullptr || named == nullptr) return;
  std::string keys;
  for (auto issue = begin; issue != issues.end(); ++issue) {
    if (is_unknown(*issue)) keys += (keys.empty() ? "" : ", ") + issue->key.substr(prefix.size());
  }
  const auto follows = [&](const Issue& issue) { return is_unknown(issue) || is_missing(issue); };
  issues.erase(std::remove_if(begin, issues.end(), follows), issues.end());
  issues.push_back({named->value.place, prefix + "calculator",
                    say("'{1}' has no inputs {2}", input.calculator->id, keys),
                    say("did you mean calculator = \"{1}\"?", better->id), Severity::error});
  mark_untyped(input.reading);
}

}  // namespace loadpath::project
