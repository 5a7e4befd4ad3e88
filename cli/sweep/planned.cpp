#include "cli/sweep/planned.hpp"

#include "cli/output.hpp"
#include "cli/points.hpp"
#include "cli/settings/settings.hpp"
#include "cli/solving.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

namespace loadpath::cli {

int refuse(const std::string& message, const std::string& hint) {
  std::cerr << "loadpath: " << message << "\n";
  if (!hint.empty()) std::cerr << "  = help: " << hint << "\n";
  return wrong_input;
}

project::Project PlannedSweep::read(std::vector<Issue>& issues) const {
  project::Project found = read_set(text, options.file, options.settings, issues, project::Ranges::taken);
  found.strict = options.strict;
  return found;
}

/// "m:min,u:max": names of results, each with an aim.
bool PlannedSweep::read_aims(std::vector<Issue>& issues) {
  const auto all = points.requested();
  for (std::size_t from = 0; !options.pareto.empty() && from <= options.pareto.size();) {
    const std::size_t to = std::min(options.pareto.find(',', from), options.pareto.size());
    const std::string part = options.pareto.substr(from, to - from);
    const std::size_t colon = part.rfind(':');
    const std::string name = part.substr(0, colon);
    const std::string aim = colon == std::string::npos ? "min" : part.substr(colon + 1);
    const auto column = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.name == name; });
    if (column == all.end() || (aim != "min" && aim != "max")) {
      std::vector<std::string> names;
      for (const auto& c : all) names.push_back(c.name);
      issues.push_back({{"--pareto", 0, 0, 1},
                        "",
                        aim == "min" || aim == "max" ? say("'{1}' is not one of the results", name)
                                                     : say("'{1}' is not an objective: min or max", aim),
                        names.empty() ? say("add it to the results: --results {1}", name) : there_is(names),
                        Severity::error});
      return false;
    }
    keep.objectives.push_back(
        {static_cast<std::size_t>(column - all.begin()), aim == "min" ? sweep::Aim::min : sweep::Aim::max});
    from = to + 1;
  }
  return true;
}

/// The demands on a Pareto set, with a result for each behind those of the project.
std::vector<project::Demand> PlannedSweep::ask_demands(std::vector<Issue>& issues) {
  if (options.pareto.empty() || options.such_that.empty()) return {};
  project::NamedResults results;
  for (const project::Placed& result : project.sweep.results) results.push_back(project::name_and_text(result.text));
  std::vector<project::Placed> such_that;
  for (const std::string& demand : options.such_that) such_that.push_back({demand, {"--such-that", 1, 1, 1}});
  std::vector<project::Demand> demands = project::demands_of(such_that, results, issues);
  std::erase_if(demands, [](const project::Demand& demand) {  // it guides a search
    return demand.kind == sweep::Constraint::Kind::at_most_one && demand.text.ends_with(" passes");
  });
  if (has_errors(issues)) return demands;
  for (std::size_t i = 0; i < demands.size(); ++i) {
    project::form(demands[i], {"--such-that", 1, 1, 1}, project, issues);
    project.sweep.results.push_back(
        {"demand " + std::to_string(i + 1) + " = " + demands[i].column, {"--such-that", 1, 1, 1}});
  }
  return demands;
}

void PlannedSweep::read_demands(const std::vector<project::Demand>& demands) {
  points.demands = demands.size();
  for (std::size_t i = 0; i < demands.size(); ++i) {
    const std::size_t column = points.columns.size() - demands.size() + i;
    keep.demands.push_back({demands[i].text, column, demands[i].kind, demands[i].bound});
  }
}

bool PlannedSweep::read_shard() {
  blocks = project::all_blocks(points);
  if (options.shard.empty()) return true;
  const auto share = read_share(options.shard, points);
  if (!share) return refuse(share.fault().message.text(), share.fault().hint.text()), false;
  blocks = *share;
  return true;
}

void PlannedSweep::plan(std::vector<Issue>& issues) {
  project = read(issues);
  take_points(options.points, project.sweep);
  for (const std::string& result : options.results) project.sweep.results.push_back({result, {"--results", 1, 1, 1}});
  const std::vector<project::Demand> demands = ask_demands(issues);
  if (!has_errors(issues)) points = project::plan_sweep(project, project.sweep, issues);
  if (!has_errors(issues)) read_demands(demands);
  keep.worst = options.worst;
  if (options.quantile > 0.0) keep.quantile = options.quantile;
  if (!has_errors(issues)) read_aims(issues);
}

bool PlannedSweep::prepare() {
  std::vector<Issue> issues;
  plan(issues);
  if (!options.quiet || has_errors(issues)) {
    std::vector<terminal::SourceText> sources{
        {options.file, text}, {"--pareto", options.pareto}, source_of(options.settings)};
    for (const std::string& result : options.results) sources.push_back({"--results", result});
    for (const std::string& demand : options.such_that) sources.push_back({"--such-that", demand});
    terminal::show_issues(issues, with_files_of(project, sources));
  }
  return !has_errors(issues) && read_shard();
}

std::string PlannedSweep::identity() const {
  const project::SweepSettings& s = project.sweep;
  std::string all = program() + "\n";
  const auto add = [&](const char* name, std::uint64_t number) {
    all += std::string(name) + " = " + std::to_string(number) + "\n";
  };
  add("samples", s.samples), add("seed", s.seed), add("latin", std::uint64_t{s.latin}), add("worst", keep.worst);
  add("strict", std::uint64_t{options.strict}), add("no-columns", std::uint64_t{options.no_columns});
  all += "pareto = " + options.pareto + "\n";
  for (const auto& demand : keep.demands) all += "such that = " + demand.text + "\n";
  all += "quantile = " + format_number(keep.quantile, 17) + "\n";
  for (const auto& zip : s.zip) {
    all += "zip = ";
    for (const project::Placed& name : zip) all += name.text + ",";
    all += "\n";
  }
  for (const auto& column : points.columns) all += column.name + " = " + column.text + "\n";
  for (const std::string& setting : options.settings) all += "set = " + setting + "\n";
  all += text + "\n";
  for (const project::NamedFile& file : project.files) all += file.name + "\n" + file.text + "\n";
  return all;
}

project::ReadAgain PlannedSweep::reading() const {
  return [this] {
    std::vector<Issue> found;
    return read(found);
  };
}

unsigned PlannedSweep::jobs() const {
  return options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
}

int PlannedSweep::refuse_all(const std::vector<Issue>& issues) const {
  std::vector<terminal::SourceText> sources{{options.file, text},
                                            source_of(options.settings),
                                            {"--minimise", options.minimise},
                                            {"--maximise", options.maximise},
                                            {"--seek", options.seek}};
  for (const std::string& demand : options.such_that) sources.push_back({"--such-that", demand});
  terminal::show_issues(issues, sources);
  return wrong_input;
}

}  // namespace loadpath::cli
