#include "cli/sweep/searches.hpp"

#include "cli/output.hpp"
#include "cli/settings/settings.hpp"
#include "cli/solving.hpp"
#include "cli/sweep/progress.hpp"
#include "lib/export/sweep/searches.hpp"
#include "lib/report/sweep/best.hpp"
#include "lib/report/sweep/influence.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

/// What a search finds with the threads of this command, while its progress is shown.
template <class Search>
auto searched(const PlannedSweep& sweep, const Search& search) {
  Progress progress(0, !sweep.options.quiet);
  auto found =
      search(project::Searching{sweep.reading(), sweep.jobs(), [&](std::uint64_t points) { progress.show(points); }});
  progress.end();
  return found;
}

/// Prints what was found other than by a sweep over all points.
template <class Found>
int report_found(const PlannedSweep& sweep, const char* title, const Found& found, std::vector<report::Block> blocks) {
  if (sweep.options.json)
    std::cout << exports::json_of(sweep.project, found);
  else if (!sweep.options.quiet)
    terminal::show_tables(blocks);
  if (sweep.options.reports.empty()) return passed;
  report::Document document;
  document.title = sweep.project.title.empty() ? sweep.project.file : sweep.project.title;
  document.meta.emplace_back(say("Project file"), sweep.project.file);
  if (!sweep.options.settings.empty()) document.meta.emplace_back(say("set"), text_of(sweep.options.settings));
  document.program = program();
  document.meta.emplace_back(say("Program"), document.program);
  blocks.insert(blocks.begin(), report::Heading{2, title, "sweep"});
  document.blocks = std::move(blocks);
  return write_reports(document, sweep.options.reports, sweep.project, sweep.options.quiet) ? passed : wrong_input;
}

}  // namespace

int choose(const PlannedSweep& sweep) {
  const bool most = !sweep.options.maximise.empty();
  project::BestRequest asked;
  asked.objective = {most ? sweep.options.maximise : sweep.options.minimise,
                     {most ? "--maximise" : "--minimise", 1, 1, 1}};
  asked.maximise = most;
  for (const std::string& demand : sweep.options.such_that)
    asked.such_that.push_back({demand, {"--such-that", 1, 1, 1}});
  if (sweep.options.quantile > 0.0) asked.quantile = sweep.options.quantile;
  for (const project::SweptResult& column : sweep.points.columns) asked.results.emplace_back(column.name, column.text);
  std::vector<Issue> issues;
  const auto best =
      searched(sweep, [&](const auto& how) { return project::find_best(how, asked, sweep.project.sweep, issues); });
  if (!best) return sweep.refuse_all(issues);
  const int code = report_found(sweep, "The best design", *best, report::best_blocks(*best));
  return code == passed && !best->optimum.allowed ? int{not_passed} : code;
}

int seek(const PlannedSweep& sweep) {
  std::vector<Issue> issues;
  const auto sought = searched(sweep, [&](const auto& how) {
    return project::seek_value(how, {sweep.options.seek, {"--seek", 1, 1, 1}}, issues);
  });
  if (!sought) return sweep.refuse_all(issues);
  const int code = report_found(sweep, "The value sought", *sought, report::seek_blocks(*sought));
  return code == passed && sought->sought.solutions.empty() ? int{not_passed} : code;
}

int ask_influence(const PlannedSweep& sweep) {
  std::vector<Issue> issues;
  const auto influence = searched(sweep, [&](const auto& how) {
    return project::find_influence(how, sweep.points, sweep.project.sweep, sweep.options.sobol, issues);
  });
  if (!influence) return sweep.refuse_all(issues);
  return report_found(sweep, "Sensitivity of the results", *influence, report::influence_blocks(*influence));
}

}  // namespace loadpath::cli
