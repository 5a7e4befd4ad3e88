#include "api/translate.hpp"
#include "calculators/catalogue.hpp"
#include "lib/export/sweep/json.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/sweep/sweep.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <loadpath/loadpath.hpp>

namespace loadpath::api {

using project::Ranges;

const char* version() { return LOADPATH_VERSION; }

namespace {

/// The project as read; an Error if it has errors.
project::Project read_again(const std::string& text, const std::string& name, Ranges ranges,
                            std::vector<loadpath::Issue>& issues) {
  project::Project project = project::read_project(text, name, catalogue(), issues, ranges);
  refuse_errors(issues, sources_of(project, {{name, text}}));
  return project;
}

void take_points(const SweepOptions& options, project::SweepSettings& settings, Sources& sources) {
  settings.samples = options.samples.value_or(settings.samples);
  settings.seed = options.seed.value_or(settings.seed);
  settings.latin = settings.latin || options.latin;
  const auto placed = [&](const char* what, std::size_t i, const std::string& text) {
    const std::string name = what + ("[" + std::to_string(i + 1) + "]");
    sources[name] = text;
    return project::Placed{text, {name, 1, 1, static_cast<int>(std::max<std::size_t>(text.size(), 1))}};
  };
  for (const std::vector<std::string>& names : options.zip) {
    auto& zip = settings.zip.emplace_back();
    for (const std::string& name : names) zip.push_back(placed("zip", settings.zip.size() - 1, name));
  }
  for (std::size_t i = 0; i < options.results.size(); ++i)
    settings.results.push_back(placed("results", i, options.results[i]));
}

/// A sweep that keeps its points.
class Keeping {
 public:
  Keeping(const project::SweepPlan& plan, bool rows) : rows_(rows) {
    sweep_.points = plan.space.count();
    for (const project::SweptInput& input : plan.inputs) sweep_.columns.push_back(column_of(input));
    results_ = plan.kept_results();
    for (const std::size_t k : plan.output_columns()) sweep_.columns.push_back(column_of(plan.columns[k]));
    for (const char* const name : {"state", "utilisation"}) sweep_.columns.push_back({name, "1", "-", {}, {}});
    if (!rows) return;
    for (Column& column : sweep_.columns) column.values.resize(sweep_.points);
  }

  void take(const project::SolvedBlock& block) {
    std::size_t column = 0;
    const auto put = [&](const std::vector<double>& values) {
      std::copy_n(values.begin(), block.count,
                  sweep_.columns[column++].values.begin() + static_cast<std::ptrdiff_t>(block.first));
    };
    for (const auto& values : block.inputs) put(values);
    for (const std::size_t result : results_) put(block.results[result]);
  }

  Sweep finish(const project::SweepStatistics& found, std::string summary) {
    if (!rows_) sweep_.columns.clear();
    std::vector<Refused> refused;
    for (const auto& [id, r] : found.refusals()) refused.push_back({r.count, r.first, r.key, r.message});
    sweep_.refused = in_order(std::move(refused));
    sweep_.summary = std::move(summary);
    return std::move(sweep_);
  }

 private:
  bool rows_;
  std::vector<std::size_t> results_;  // results of a block that have a column
  Sweep sweep_;
};

}  // namespace

Project::Project(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {
  std::vector<loadpath::Issue> issues;
  project::Project project = read_again(text_, name_, Ranges::taken, issues);
  title_ = project.title;
  for (const auto& step : project.steps) steps_.push_back(step->name());
  for (const project::SweptInput& input : project::swept_inputs(project)) swept_.push_back(input.name);
}

Project Project::read(std::string text, std::string name) { return {std::move(text), std::move(name)}; }

Project Project::open(const std::string& file) {
  std::string text;
  if (file == "-" || !toml::read_file(file, text)) refuse(say("cannot read '{1}'", file));
  return {std::move(text), file};
}

Solution Project::solve(bool strict) const {
  std::vector<loadpath::Issue> issues;
  project::Project project = read_again(text_, name_, Ranges::refused, issues);
  project.strict = strict;
  return solution_of(project, std::move(issues), sources_of(project, {{name_, text_}}));
}

Solution Project::solve_point(std::uint64_t point, const SweepOptions& points) const {
  std::vector<loadpath::Issue> issues;
  project::Project project = read_again(text_, name_, Ranges::taken, issues);
  Sources sources = sources_of(project, {{name_, text_}});
  project.strict = points.strict;
  take_points(points, project.sweep, sources);
  const project::SweepPlan plan = project::plan_sweep(project, project.sweep, issues);
  refuse_errors(issues, sources);
  if (point >= plan.space.count())
    refuse(say("point {1} does not exist: the sweep has {2}, counted from 0", std::to_string(point),
               std::to_string(plan.space.count())));
  project::set_point(project, plan, point, issues);
  return solution_of(project, std::move(issues), sources);
}

Sweep Project::sweep(const SweepOptions& options) const {
  std::vector<loadpath::Issue> issues;
  project::Project project = read_again(text_, name_, Ranges::taken, issues);
  Sources sources = sources_of(project, {{name_, text_}});
  project.strict = options.strict;
  take_points(options, project.sweep, sources);
  const project::SweepPlan plan = project::plan_sweep(project, project.sweep, issues);
  project::refuse_open_ranges(plan, issues);
  refuse_errors(issues, sources);
  const project::Keep keep;
  project::SweepStatistics found = project::nothing_found(plan, project, keep);
  Keeping kept(plan, options.rows);
  const auto read = [&] {
    std::vector<loadpath::Issue> again;
    project::Project own = read_again(text_, name_, Ranges::taken, again);
    own.strict = options.strict;
    return own;
  };
  bool stopped = false;
  const project::SweepWork work{plan, read, keep, project::all_blocks(plan), threads_for(options.jobs), options.rows};
  project::solve(work, [&](project::SweptPart&& part) {
    for (const project::SolvedBlock& block : part.rows) kept.take(block);
    found.merge(part.found);
    const std::uint64_t done = std::min(part.blocks.last * project::block_size, plan.space.count());
    stopped = options.goes_on && !options.goes_on(done, plan.space.count());
    return !stopped;
  });
  if (stopped) refuse(say("the sweep was stopped"));
  return kept.finish(found, exports::json_of(project, plan, found, std::string("loadpath ") + version()));
}

}  // namespace loadpath::api
