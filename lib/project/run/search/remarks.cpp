#include "lib/project/run/search/remarks.hpp"

#include "lib/project/run/evaluation/searched_rules.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace loadpath::project {

namespace {

bool holds_throughout(Evaluation& evaluation, std::size_t rule) {
  for (std::size_t i = 0; i < evaluation.positions(); ++i) {
    if (evaluation.set_position(i) && !evaluation.holds(rule)) return false;
  }
  return true;
}

}  // namespace

Issue aimless_search(const PreparedStep& step, const Search& wanted) {
  std::vector<std::string> asking;
  const auto ask = [&](const FieldInfo& f) {
    if (f.role != Role::check) return;
    for (const std::string& input : listed_keys(f.asked_by)) {
      if (std::find(asking.begin(), asking.end(), input) == asking.end()) asking.push_back(input);
    }
  };
  for (const FieldInfo& f : step.input().calculator->result->fields) {
    ask(f);
    std::for_each(f.fields.begin(), f.fields.end(), ask);
  }
  std::string names;
  for (const std::string& inputs : asking) names += ", " + inputs;
  return issue_at(step.input(), wanted.path, say("'{1}' cannot be sized: no check is active", wanted.path),
                  say("give {1}, or an input of a check: {2}", wanted.path, names.empty() ? "" : names.substr(2)));
}

void warn_of_customs(Evaluation& evaluation, std::vector<Issue>& issues) {
  const auto& rules = evaluation.calculator().rules;
  for (std::size_t rule = 0; rule < rules.size(); ++rule) {
    if (!rules[rule].only_warns || !waits_for_search(evaluation.step(), rule)) continue;
    if (!holds_throughout(evaluation, rule)) issues.push_back(evaluation.broken_rule(rule));
  }
}

void warn_of_found(Evaluation& evaluation, const Search& wanted, std::vector<Issue>& issues) {
  if (!wanted.leaf) return;
  const FieldInfo& field = *wanted.leaf.field;
  const double found = evaluation.inputs().leaf(wanted.path).get();
  if (field.plausible.holds(found)) return;
  Issue issue = issue_at(evaluation.step().input(), wanted.path, unusual(wanted.path, field, found));
  issue.place = wanted.place;
  issue.severity = Severity::warning;
  issues.push_back(std::move(issue));
}

}  // namespace loadpath::project
