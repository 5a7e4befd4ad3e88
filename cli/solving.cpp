#include "cli/solving.hpp"

#include "cli/output.hpp"
#include "lib/io/json.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

/// Issues where they belong: as JSON on standard output for a program that asked for it, else on standard error.
void tell(const std::vector<Issue>& issues, const std::vector<SourceText>& sources, const OutputOptions& output) {
  if (output.json && has_errors(issues)) std::cout << io::json_of(issues);
  if (!output.quiet || has_errors(issues)) show_issues(issues, sources);
}

}  // namespace

int exit_for(const std::vector<report::Verdict>& verdicts) {
  return report::worst(verdicts) == report::State::pass ? passed : not_passed;
}

int solve_and_show(const ReadProject& read, const std::vector<SourceText>& sources, const OutputOptions& output,
                   bool in_full) {
  std::vector<Issue> issues;
  project::Project project = read(issues);
  if (!has_errors(issues)) project::solve(project, issues);
  tell(issues, sources, output);
  if (has_errors(issues)) return wrong_input;
  if (!write(project, output)) return wrong_input;
  if (output.json) {
    std::cout << io::json_of(project, program());
  } else if (!output.quiet) {
    show_project(project, in_full);
  }
  return exit_for(project::verdicts(project));
}

}  // namespace loadpath::cli
