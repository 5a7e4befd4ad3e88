#include "lib/report/terminal/why.hpp"

#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/points.hpp"
#include "cli/settings/settings.hpp"
#include "cli/solving.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/summary/summary.hpp"
#include "lib/toml/tree.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

/// Reports an unknown step, with the steps of the file.
int refuse_step(const project::Project& project, const std::string& name) {
  const Fault fault = project.unknown_step(name);
  std::cerr << "loadpath: " << fault.message.text() << "\n  = help: " << fault.hint.text() << "\n";
  return wrong_input;
}

}  // namespace

int why(const WhyOptions& options) {
  if (const std::string wrong = needs_point(options.points); !wrong.empty() && !options.point) {
    std::cerr << "loadpath: " << wrong << "\n  = help: add --point N, or use `loadpath sweep`\n";
    return wrong_input;
  }
  std::string text;
  if (!toml::read_file(options.file, text)) {
    std::cerr << "loadpath: cannot read '" << options.file << "'\n  = help: " << help_for_file(options.file)
              << "; the file comes first: `loadpath why FILE STEP`\n";
    return wrong_input;
  }
  const std::string name = options.file == "-" ? "standard input" : options.file;
  std::vector<Issue> issues;
  using project::Ranges;
  project::Project project =
      read_set(text, name, options.settings, issues, options.point ? Ranges::taken : Ranges::refused);
  take_points(options.points, project.sweep);
  if (options.point && !has_errors(issues)) take_point(project, *options.point, issues);
  // A complete step is represented by its results, which may be series.
  const bool is_path = options.of.find('.') != std::string::npos;
  const project::SeriesChoice asked = is_path ? project::SeriesChoice({options.of}) : project::SeriesChoice();
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = true, .series = asked});
  terminal::show_issues(issues, with_files_of(project, {{name, text}, source_of(options.settings)}));
  if (has_errors(issues)) return wrong_input;
  if (options.of.empty()) {
    const project::Step* const decides = project.find(report::summarise(project).governing_step);
    if (decides != nullptr) terminal::show_why(project, *decides, "");
    return exit_for(project::modes(project));
  }
  const std::size_t dot = options.of.find('.');
  const project::Step* const step = project.find(options.of.substr(0, dot));
  if (step == nullptr) return refuse_step(project, options.of);
  if (!terminal::show_why(project, *step, dot == std::string::npos ? "" : options.of.substr(dot + 1)))
    return wrong_input;
  return exit_for(step->account().modes);
}

}  // namespace loadpath::cli
