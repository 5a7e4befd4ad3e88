// The combined state of a project's failure modes.
#pragma once

#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/step_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// The state of a mode of a step, in its words; "none" where it does not concern the part.
inline std::string mode_of(const project::Project& project, std::string_view step, std::string_view id) {
  for (const account::Mode& mode : project::modes(project)) {
    if (mode.id == id && mode.step == step) return account::slug(mode.state);
  }
  return "none";
}

/// The same of a calculator's example with other lines.
inline std::string mode_with(std::string_view calculator, const std::string& lines, std::string_view id) {
  const ExampleStep step(calculator, lines);
  REQUIRE_MESSAGE(step.fault().empty(), step.fault());
  return mode_of(step.project(), step.project().steps[0]->name(), id);
}

/// A project as its text, solved.
inline project::Project solved_as_found(const std::string& text) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "found.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  for (const Issue& issue : issues) CHECK_MESSAGE(issue.severity != Severity::error, issue.message.text());
  return project;
}

/// The first error of a project and its hint; empty if it has none.
inline std::string first_error_of(const std::string& text) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "found.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error) return issue.message.text() + " | " + issue.hint.text();
  }
  return "";
}

}  // namespace loadpath::test
