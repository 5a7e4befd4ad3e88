#include "cli/points.hpp"

namespace loadpath::cli {

namespace {

std::vector<project::Placed> split(const std::string& list, const char* option) {
  std::vector<project::Placed> all;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    std::string name = list.substr(from, to - from);
    while (name.starts_with(' ')) name.erase(0, 1);
    while (name.ends_with(' ')) name.pop_back();
    all.push_back({std::move(name), {option, 1, 1, 1}});
    from = to + 1;
  }
  return all;
}

}  // namespace

void take_points(const PointOptions& options, project::SweepSettings& settings) {
  settings.samples = options.samples.value_or(settings.samples);
  settings.seed = options.seed.value_or(settings.seed);
  settings.latin = settings.latin || options.latin;
  for (const std::string& zip : options.zip) settings.zip.push_back(split(zip, "--zip"));
}

void take_point(project::Project& project, std::uint64_t point, std::vector<Issue>& issues) {
  const project::SweepPlan plan = project::plan_sweep(project, project.sweep, issues);
  if (has_errors(issues)) return;
  if (point >= plan.space.count()) {
    issues.push_back({{"--point", 0, 0, 1},
                      "",
                      say("there is no point {1}: the sweep has {2}, counted from 0", std::to_string(point),
                          std::to_string(plan.space.count())),
                      {},
                      Severity::error});
    return;
  }
  project::set_point(project, plan, point, issues);
  project.meta.emplace_back("point", std::to_string(point) + " of " + std::to_string(plan.space.count()));
}

}  // namespace loadpath::cli
