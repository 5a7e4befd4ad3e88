#include "lib/project/solving/solve.hpp"

#include "lib/project/accept.hpp"
#include "lib/project/fixes.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/references/factors/factors.hpp"
#include "lib/project/references/kinds.hpp"
#include "lib/project/references/machine/machine.hpp"
#include "lib/project/references/meanings.hpp"
#include "lib/project/references/order.hpp"
#include "lib/project/references/paths/circles.hpp"
#include "lib/project/references/reductions.hpp"
#include "lib/project/references/senses.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/project/solving/bodies.hpp"
#include "lib/project/solving/body_facts.hpp"
#include "lib/project/solving/companions.hpp"
#include "lib/project/solving/elements.hpp"
#include "lib/project/solving/row_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

/// The values that expectations refer to, and that inputs are compared with.
std::set<std::string> compared_values(const Project& project) {
  std::set<std::string> compared;
  for (const auto& step : project.steps)
    for_each_compared(step->input(), [&](const std::string& path) { compared.insert(path); });
  for (const Expectation& e : project.expectations) {
    for (const auto& reference : e.value.references()) compared.insert(reference.path);
  }
  return compared;
}

/// The series that steps refer to, and the load components that act with them.
std::set<std::string> taken_series(const Project& project) {
  std::set<std::string> taken(project.references.begin(), project.references.end());
  for (const auto& step : project.steps) {
    for_each_loading_reference(step->input().reading, [&](const std::string& path) {
      for (std::string& companion : companions_of(project, path)) taken.insert(std::move(companion));
    });
  }
  return taken;
}

/// The access of steps to one another while the project is solved.
Known known_of(const Project& project) {
  static const Value none{{}, {std::numeric_limits<double>::quiet_NaN()}};
  const auto value = [&project](const std::string& path) -> const Value& {
    const Value* known = project.value(path);
    return known == nullptr ? none : *known;
  };
  const auto word = [&project](const std::string& path) {
    const auto [name, rest] = split_step(path);
    const Step* const step = project.find(name);
    return step == nullptr ? std::string() : step->word(rest);
  };
  const auto within = [&project](const std::string& path) {
    const auto [name, rest] = split_step(path);
    return project.find(name)->within(rest);
  };
  return {value, word, within};
}

/// A warning in the report of its step: after the path that it concerns, unless it starts with that.
Message of_step(const Issue& warning, const std::string& step) {
  const std::string path = warning.key.substr(std::min(step.size() + 1, warning.key.size()));
  return warning.message.text().starts_with(path) ? warning.message : say("{1}: {2}", path, warning.message);
}

/// Passes warnings about violated customs to the steps that they concern.
void hand_out_warnings(Project& project, const std::vector<Issue>& issues) {
  for (const Issue& issue : issues) {
    if (issue.severity != Severity::warning) continue;
    for (const auto& step : project.steps) {
      if ((issue.key + ".").starts_with(step->name() + ".")) step->warn(of_step(issue, step->name()));
    }
  }
}

}  // namespace

Wanted with_references(const Project& project, Wanted wanted) {
  wanted.taken.merge(taken_series(project));
  wanted.compared.merge(compared_values(project));
  return wanted;
}

void solve(Project& project, std::vector<Issue>& issues, Wanted wanted) {
  solve_again(project, issues, with_references(project, std::move(wanted)));
}

namespace {

/// Values of one step that others take, by path.
using Handed = std::map<std::string, std::pair<std::vector<double>, std::string>>;

/// Records the current values that a step takes from another one.
void note_taken(const Project& project, const Step& taker, const Step& of, Handed& taken) {
  for_each_reference(taker.input().reading, [&](const std::string& path) {
    const auto [name, rest] = split_step(path);
    if (name != of.name()) return;
    const Value* const value = project.value(path);
    taken[path] = {value == nullptr ? std::vector<double>{} : value->si, of.word(rest)};
  });
}

bool is_alike(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// "key1.R_e_1 takes shaft.R_e (line 73)": the inputs that a step was solved without first.
std::string waiting_inputs(const Step& step, const std::set<std::string>& without) {
  std::string all;
  for (const Operand& operand : step.input().reading.operands) {
    const auto& references = operand.expression.references();
    if (without.contains(operand.path) && !references.empty())
      all += (all.empty() ? "" : ", ") + how_taken(step, references.front().path).text();
  }
  return all;
}

/// The step that takes a value of another one, and how.
Message taker_of(const Project& project, const std::string& path) {
  for (const auto& step : project.steps) {
    bool takes = false;
    for_each_reference(step->input().reading, [&](const std::string& other) { takes = takes || other == path; });
    if (takes) return how_taken(*step, path);
  }
  return say("a step takes {1}", path);
}

/// A step was solved without some inputs first: values that others have taken from it must not depend on them.
void refuse_other_values(const Handed& before, const Project& project, const Step& step,
                         const std::set<std::string>& without, std::vector<Issue>& issues) {
  for (const auto& [path, taken] : before) {
    const Value* const value = project.value(path);
    const bool same = is_alike(taken.first, value == nullptr ? std::vector<double>{} : value->si);
    if (same && taken.second == step.word(split_step(path).second)) continue;
    const std::string input = without.empty() ? "" : *without.begin();
    Issue issue = issue_at(step.input(), input, say("circular reference: '{1}' depends on its own results", path), {});
    issue.hint =
        say("{1}, and {2}: write a value for {3}", waiting_inputs(step, without), taker_of(project, path), input);
    issues.push_back(std::move(issue));
    return;
  }
}

}  // namespace

namespace {

/// Solves all steps in their order, with the currently known sizes that bodies require.
void solve_steps(Project& project, std::vector<Issue>& issues, const Wanted& wanted) {
  const Known known = known_of(project);
  const Declared declared = [&](const std::string& path) { return project.signature(path); };
  for (const auto& step : project.steps) step->forget();
  for (auto& [path, value] : project.beforehand) value = value_beforehand(project, path).value_or(Value{});
  std::map<std::size_t, Handed> provisional;
  std::map<std::size_t, std::set<std::string>> left_out;
  std::vector<RowPair> pairs = row_pairs(project);
  for (const Pass& pass : project.passes) {
    Step& step = *project.steps[pass.step];
    std::erase_if(pairs, [&](const RowPair& pair) {
      const bool is_of_it = pass.step == pair.a || pass.step == pair.b;
      if (is_of_it) find_rows_together(project, pair, known);
      return is_of_it;
    });
    if (!pass.without.empty()) {
      step.solve_without(pass.without, known);
      provisional[pass.step] = {};
      left_out[pass.step] = pass.without;
      continue;
    }
    for (auto& [other, taken] : provisional) note_taken(project, step, *project.steps[other], taken);
    step.forget();
    check_factors(step, project, issues);
    check_meanings(step, project, issues);
    check_reductions(step, project);
    check_machine(step, project);
    check_senses(step, project, issues);
    if (wanted.words) check_kinds(step, project, declared, issues);
    if (!has_errors(issues)) step.solve(known, wanted, issues);
    if (has_errors(issues)) return;
    if (const auto before = provisional.extract(pass.step))
      refuse_other_values(before.mapped(), project, step, left_out[pass.step], issues);
    if (has_errors(issues)) return;
  }
}

}  // namespace

void solve_again(Project& project, std::vector<Issue>& issues, const Wanted& wanted) {
  constexpr int most_rounds = 20;
  for (const auto& step : project.steps) step->forget_body();
  const std::size_t before = issues.size();
  for (int round = 0; true; ++round) {
    solve_steps(project, issues, wanted);
    const bool is_settled =
        has_errors(issues) ||
        !(hand_out_sizes(project, issues) || hand_out_facts(project, issues) || hand_out_contradictions(project));
    if (is_settled) break;
    issues.resize(before);  // they are reported again with the sizes of the bodies
    if (round < most_rounds) continue;
    issues.push_back({project.steps.front()->input().place, "body", say("the sizes of the bodies do not converge"),
                      say("give one of them a value"), Severity::error});
    break;
  }
  if (has_errors(issues)) return;
  settle_left(project);
  settle_elements(project);
  name_fixes(project);
  for (const auto& step : project.steps) warn_of_idle_acceptances(*step, issues);
  hand_out_warnings(project, issues);
}

}  // namespace loadpath::project
