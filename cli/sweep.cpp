#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/project/sweep/blocks.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/toml/tree.hpp"

#include <iostream>

namespace loadpath::cli {

int sweep(const SweepOptions& options) {
  std::string text;
  if (!toml::read_file(options.file, text)) {
    std::cerr << "loadpath: cannot read '" << options.file << "'\n";
    return wrong_input;
  }
  std::vector<Issue> issues;
  const auto read = [&](std::vector<Issue>& found) {
    return project::read_project(text, options.file, catalogue(), found, project::Ranges::taken);
  };
  project::Project project = read(issues);
  for (const std::string& r : options.results) project.sweep.results.push_back({r, {"--results", 1, 1, 1}});
  const std::vector<project::Placed> asked = project.sweep.results;
  project::SweepPlan plan;
  if (!has_errors(issues)) plan = project::plan_sweep(project, project.sweep, issues);
  terminal::show_issues(issues, {{options.file, text}});
  if (has_errors(issues)) return wrong_input;
  std::vector<std::string> results;
  for (const auto& r : asked) results.push_back(r.text);
  const auto again = [&] {
    std::vector<Issue> none;
    return read(none);
  };
  for (const auto& input : plan.inputs) std::cout << input.name << ",";
  for (const auto& c : plan.columns) std::cout << c.name << ",";
  std::cout << "state\n";
  project::solve_blocks(plan, again, results, project::all_blocks(plan), options.jobs, [&](const auto& block) {
    for (std::size_t i = 0; i < block.count; ++i) {
      for (const auto& c : block.inputs) std::cout << format_exact(c[i]) << ",";
      for (std::size_t k = 0; k < plan.columns.size() + 2; ++k) std::cout << format_exact(block.results[k][i]) << ",";
      std::cout << "\n";
    }
    for (const auto& r : block.refusals) std::cout << "# " << r.row + block.first << " " << r.issue.message.text() << "\n";
    return true;
  });
  return passed;
}

}  // namespace loadpath::cli
