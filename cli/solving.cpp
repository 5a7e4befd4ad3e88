#include "cli/solving.hpp"

#include "cli/exit.hpp"
#include "cli/output.hpp"
#include "cli/typed_remedies.hpp"
#include "cli/version.hpp"
#include "lib/account/conclusion.hpp"
#include "lib/export/json.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/unknown_series.hpp"
#include "lib/project/verify.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace loadpath::cli {

namespace {

/// Reports issues: as JSON on standard output for a program that requested it, else on standard error.
void print_issues(const std::vector<Issue>& issues, const std::vector<terminal::SourceText>& sources,
                  const OutputOptions& output) {
  if (output.json && has_errors(issues)) std::cout << exports::json_of(issues);
  if (!output.quiet || has_errors(issues)) terminal::show_issues(with_flags(issues), sources);
}

/// The terminal shows what series there are; where nothing shows or writes them, none is made. Patterns are compared
/// with those that there are.
project::SeriesChoice series_for(const OutputOptions& output, bool shown, bool written) {
  if (shown) return {};
  const bool asked = written || !output.csv.empty() || !output.series.empty();
  return asked ? project::SeriesChoice(output.series) : project::SeriesChoice::none();
}

/// Content for viewing is made only if it is viewed: the terminal shows the extremes of every series.
project::Wanted wanted_by(const OutputOptions& output, report::Detail detail) {
  const bool in_full = detail == report::Detail::full;  // or in short, with the formulas of one check
  const bool shown = !output.json && !output.quiet && !takes_standard_output(output);
  const bool drawn = !output.reports.empty() || !output.svg.empty() || !output.dxf.empty();
  const bool written = !output.reports.empty() || output.json;
  return {.pictures = drawn || (shown && in_full),
          .formulas = written || (shown && in_full),
          .warnings = !output.quiet,  // nothing else shows them
          .series = series_for(output, shown, written)};
}

/// Reports patterns without a match; the series are known once the project is solved.
void check_series(const project::Project& project, const OutputOptions& output, std::vector<Issue>& issues) {
  for (const FieldFault& fault : project::unknown_series(project::SeriesChoice(output.series), project))
    issues.push_back({{"--series", 0, 0, 1}, "", fault.message, fault.hint, Severity::error});
}

/// The user's input, unchanged: files, and the words of the shell.
std::string input_of(const std::vector<terminal::SourceText>& sources) {
  std::string all;
  for (const terminal::SourceText& source : sources) {
    if (source.text.empty()) continue;
    const bool typed = source.file.starts_with("--");
    all += typed ? source.file + " " + source.text + "\n" : source.text;
  }
  return all;
}

/// With the report that the project names, relative to its file, where the shell names none.
OutputOptions with_report_of(const project::Project& project, OutputOptions output) {
  if (!output.report_of_project || !output.reports.empty() || project.report.empty()) return output;
  const std::filesystem::path folder = std::filesystem::path(project.file).parent_path();
  output.reports.push_back((folder / project.report).string());
  return output;
}

/// Reports values that differ from the project's expectations, which are not part of its verdict.
void print_misses(const project::Project& project) {
  const auto all = project::compare(project);
  const auto misses = std::count_if(all.begin(), all.end(), [](const project::Comparison& c) { return !c.holds; });
  if (misses == 0) return;
  std::cerr << misses << " of " << all.size() << (all.size() == 1 ? " expectation misses" : " expectations miss")
            << ": `loadpath verify " << (project.file == "standard input" ? "-" : project.file) << "` shows them\n";
}

/// Whether the tables of the parts are shown, and not the short answer.
bool shows_tables(const OutputOptions& output) {
  return output.full || output.detail == "normal" || output.detail == "full";
}

void show(const project::Project& project, const OutputOptions& output, report::Detail detail, bool is_calculation) {
  if (output.modes) return terminal::show_modes(project);
  if (shows_tables(output)) return terminal::show_project(project, detail);
  is_calculation ? terminal::show_calculation(project) : terminal::show_short(project);
}

}  // namespace

std::vector<terminal::SourceText> with_files_of(const project::Project& project,
                                                std::vector<terminal::SourceText> sources) {
  for (const project::NamedFile& file : project.files) sources.push_back({file.name, file.text});
  return sources;
}

int exit_for(account::Headline headline) {
  switch (headline) {
    case account::Headline::pass:
      return passed;
    case account::Headline::incomplete:
      return incomplete;
    default:
      return not_passed;
  }
}

int exit_for(const account::Modes& modes) { return exit_for(account::conclude(modes).headline); }

int solve_and_show(const ReadProject& read, const std::vector<terminal::SourceText>& sources,
                   const OutputOptions& asked, report::Detail usual) {
  const report::Detail detail = detail_of(asked, usual);
  std::vector<Issue> issues;
  project::Project project = read(issues);
  const OutputOptions output = with_report_of(project, asked);
  if (output.reports != asked.reports && !has_errors(issues) && !can_write(output)) return wrong_input;
  if (output.brief && output.reports.empty()) {
    std::cerr << "loadpath: --brief needs --report FILE\n";
    return wrong_input;
  }
  project.strict = output.strict;
  if (!has_errors(issues)) project::solve(project, issues, wanted_by(output, detail));
  if (!has_errors(issues)) check_series(project, output, issues);
  print_issues(issues, with_files_of(project, sources), output);
  if (has_errors(issues)) return wrong_input;
  if (!write(project, output, input_of(sources))) return wrong_input;
  if (output.json) {
    std::cout << exports::json_of(project, program(), project::SeriesChoice(output.series));
  } else if (output.quiet) {
    if (!takes_standard_output(output)) terminal::show_unless_passed(project);
  } else if (!takes_standard_output(output)) {
    show(project, output, detail, usual == report::Detail::full);
  }
  if (!output.quiet) print_misses(project);
  return exit_for(project::modes(project));
}

}  // namespace loadpath::cli
