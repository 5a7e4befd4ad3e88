// A project with ranges, swept in the process of the test.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/sweep/sweep.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace loadpath::test {

struct Swept {
  explicit Swept(std::string of, const std::vector<std::string>& results = {}, unsigned jobs = 1,
                 project::Keep kept = {}, project::Catalogue of_program = catalogue())
      : text(std::move(of)), keep(std::move(kept)), known(of_program) {
    project::Project project = read(issues);
    if (has_errors(issues)) return;
    for (const std::string& result : results) project.sweep.results.push_back({result, {"--results", 1, 1, 1}});
    plan = project::plan_sweep(project, project.sweep, issues);
    if (has_errors(issues)) return;
    inputs.resize(plan.inputs.size());
    columns.resize(plan.columns.size() + project::verdict_columns(project).size());
    for (const auto& column : project::verdict_columns(project)) verdicts.push_back(column.name);
    sum = project::nothing_found(plan, project, keep);
    const project::SweepWork work{plan, [this] { return read_again(); }, keep, project::all_blocks(plan), jobs, true};
    project::solve(work, [this](project::SweptPart&& part) {
      for (const project::SolvedBlock& block : part.rows) take(block);
      CHECK(sum.merge(part.found));
      return true;
    });
  }

  [[nodiscard]] project::Project read(std::vector<Issue>& found) const {
    return project::read_project(text, "part.toml", known, found, project::Ranges::taken);
  }
  [[nodiscard]] project::Project read_again() const {
    std::vector<Issue> none;
    return read(none);
  }
  /// "step.field: message = hint", a line each.
  [[nodiscard]] std::string errors() const {
    std::string all;
    for (const Issue& issue : issues) {
      if (issue.severity == Severity::error)
        all += issue.key + ": " + issue.message.text() + " = " + issue.hint.text() + "\n";
    }
    return all;
  }
  [[nodiscard]] const std::vector<double>& column(const std::string& name) const {
    for (std::size_t k = 0; k < plan.columns.size(); ++k) {
      if (plan.columns[k].name == name) return columns[k];
    }
    const auto found = std::find(verdicts.begin(), verdicts.end(), name);
    REQUIRE_MESSAGE(found != verdicts.end(), name);
    return columns[plan.columns.size() + static_cast<std::size_t>(found - verdicts.begin())];
  }
  [[nodiscard]] const std::vector<double>& input(const std::string& name) const {
    const auto found =
        std::find_if(plan.inputs.begin(), plan.inputs.end(), [&](const auto& i) { return i.name == name; });
    REQUIRE_MESSAGE(found != plan.inputs.end(), name);
    return inputs[static_cast<std::size_t>(found - plan.inputs.begin())];
  }

  std::string text;
  project::Keep keep;
  project::Catalogue known;
  std::vector<Issue> issues;
  project::SweepStatistics sum;
  project::SweepPlan plan;
  std::vector<std::string> verdicts;
  std::vector<std::vector<double>> inputs, columns;
  std::vector<std::string> refusals;  // "17: message"

 private:
  void take(const project::SolvedBlock& block) {
    for (std::size_t k = 0; k < inputs.size(); ++k)
      inputs[k].insert(inputs[k].end(), block.inputs[k].begin(), block.inputs[k].end());
    for (std::size_t k = 0; k < columns.size(); ++k)
      columns[k].insert(columns[k].end(), block.results[k].begin(), block.results[k].end());
    for (const project::Refusal& refusal : block.refusals)
      refusals.push_back(std::to_string(block.first + refusal.row) + ": " + refusal.issue.message.text());
  }
};

}  // namespace loadpath::test
