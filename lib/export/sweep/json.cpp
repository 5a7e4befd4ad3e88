#include "lib/export/sweep/json.hpp"

#include "lib/account/state.hpp"
#include "lib/export/json_writer.hpp"
#include "lib/export/sweep/json_values.hpp"

#include <array>
#include <cmath>

namespace loadpath::exports {

namespace {

using project::SweepPlan;
using project::SweepStatistics;
using project::Tally;

constexpr double confidence = 0.95;

std::int64_t whole(std::uint64_t n) { return static_cast<std::int64_t>(n); }

void write_inputs(JsonWriter& json, const SweepPlan& plan) {
  json.key("inputs").open_array();
  for (const project::SweptInput& input : plan.inputs) {
    json.open_object();
    json.member("name", input.name);
    json.member("unit", si_of(input.dimension));
    if (input.distribution) {
      static constexpr std::array names{"normal", "uniform", "triangular", "lognormal", "weibull"};
      json.member("distribution", names[input.distribution->law().index()]);
      json.member("mean", input.distribution->mean());
      json.member("sd", input.distribution->sd());
    } else {
      const std::uint64_t last = input.axis.size() - 1;
      json.member("values", whole(input.axis.size()));
      json.key("first"), write_value(json, input, input.axis.at(0));
      json.key("last"), write_value(json, input, input.axis.at(last));
    }
    json.close_object();
  }
  json.close_array();
}

void write_extreme(JsonWriter& json, const char* name, const sweep::Extreme& extreme) {
  json.key(name).open_object();
  json.member("value", extreme.value);
  if (!std::isnan(extreme.value)) json.member("point", whole(extreme.index));
  json.close_object();
}

void write_result(JsonWriter& json, const project::SweptResult& column, const sweep::Summary& summary) {
  const sweep::Moments moments = summary.moments();
  const sweep::Ranks ranks = summary.ranks();
  json.open_object();
  json.member("name", column.name);
  json.member("of", column.text);
  json.member("unit", si_of(column.dimension));
  json.member("count", whole(summary.count()));
  json.member("missing", whole(summary.missing()));
  json.member("mean", moments.mean());
  json.member("sd", moments.sd());
  json.member("skewness", moments.skewness());
  json.member("kurtosis", moments.kurtosis());
  write_extreme(json, "min", summary.min());
  write_extreme(json, "max", summary.max());
  json.key("quantiles").open_array();
  for (const double p : {0.001, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 0.999}) {
    const sweep::Interval bounds = ranks.quantile_bounds(p, confidence);
    json.open_object();
    json.member("p", p);
    json.member("value", ranks.quantile(p));
    json.member("low", bounds.low);
    json.member("high", bounds.high);
    json.close_object();
  }
  json.close_array();
  const sweep::Histogram histogram = ranks.histogram(30);
  json.key("histogram").open_object();
  json.member("edges", histogram.edges);
  json.key("counts").open_array(JsonWriter::Items::side_by_side);
  for (const std::uint64_t count : histogram.counts) json.write(whole(count));
  json.close_array();
  json.close_object();
  json.close_object();
}

void write_tally(JsonWriter& json, const Tally& tally) {
  using account::State;
  json.key("points").open_object();
  for (const State state : {State::pass, State::accepted, State::open, State::not_judged, State::not_covered,
                            State::not_available, State::fail})
    json.member(account::slug(state), whole(tally.of(state)));
  json.member("refused", whole(tally.refused_points()));
  json.close_object();
  const std::uint64_t n = tally.total() - tally.refused_points(), fails = tally.of(State::fail);
  if (n == 0) return;
  const sweep::Interval bounds = sweep::share_bounds(fails, n, confidence);
  json.key("fails").open_object();
  json.member("share", static_cast<double>(fails) / static_cast<double>(n));
  json.member("low", bounds.low);
  json.member("high", bounds.high);
  json.close_object();
  write_extreme(json, "largest_utilisation", tally.largest);
}

void write_modes(JsonWriter& json, const project::Project& project, const SweepPlan& plan,
                 const SweepStatistics& found) {
  const auto columns = project::verdict_columns(project);
  json.key("verdict").open_object();
  if (const auto headline = project::headline_of(plan, found)) json.member("headline", account::word(*headline));
  write_tally(json, found.tallies().front());
  json.close_object();
  json.key("modes").open_array();
  for (std::size_t t = 1; t < found.tallies().size(); ++t) {
    if (found.tallies()[t].total() == found.tallies()[t].refused_points()) continue;
    json.open_object();
    json.member("step", columns[2 * t].step);
    json.member("mode", columns[2 * t].mode);
    write_tally(json, found.tallies()[t]);
    json.close_object();
  }
  json.close_array();
}

void write_point(JsonWriter& json, const SweepPlan& plan, std::uint64_t index, const std::vector<double>& values) {
  const std::size_t inputs = plan.inputs.size();
  json.member("point", whole(index));
  json.key("inputs").open_object();
  for (std::size_t i = 0; i < inputs; ++i) json.key(plan.inputs[i].name), write_value(json, plan.inputs[i], values[i]);
  json.close_object();
  json.key("results").open_object();
  for (std::size_t k = 0; k < plan.requested().size(); ++k) json.member(plan.columns[k].name, values[inputs + k]);
  json.close_object();
}

void write_points(JsonWriter& json, const SweepPlan& plan, const SweepStatistics& found) {
  json.key("worst").open_array();
  for (const auto& row : found.worst()) {
    json.open_object();
    json.member("utilisation", row.key);
    write_point(json, plan, row.index, row.values);
    json.close_object();
  }
  json.close_array();
  if (found.keep().objectives.empty() || found.designs().asked().samples > 1) return;
  json.key("pareto").open_array();
  for (const auto& point : found.pareto()) {
    json.open_object();
    write_point(json, plan, point.index, point.values);
    json.member("equals", whole(point.equals));
    json.close_object();
  }
  json.close_array();
}

void write_design(JsonWriter& json, const SweepPlan& plan, const SweepStatistics& found, std::uint64_t design,
                  const std::vector<double>& results) {
  const std::vector<double> values = plan.at(design * found.designs().asked().samples);
  json.member("design", whole(design));
  json.key("inputs").open_object();
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    if (!plan.inputs[i].distribution) json.key(plan.inputs[i].name), write_value(json, plan.inputs[i], values[i]);
  }
  json.close_object();
  json.key("results").open_object();
  for (std::size_t k = 0; k < plan.requested().size(); ++k) json.member(plan.columns[k].name, results[k]);
  json.close_object();
}

void write_row(JsonWriter& json, const SweepPlan& plan, const SweepStatistics& found, const project::DesignRow& row) {
  const project::DesignTally& tally = row.tally;
  const sweep::Interval bounds = sweep::share_bounds(tally.failing, tally.samples, confidence);
  json.open_object();
  write_design(json, plan, found, row.design, row.results);
  json.member("passing", whole(tally.passing));
  json.member("failing", whole(tally.failing));
  json.member("refused", whole(tally.refused));
  json.key("fails").open_object();
  json.member("share", static_cast<double>(tally.failing) / static_cast<double>(tally.samples));
  json.member("low", bounds.low);
  json.member("high", bounds.high);
  json.close_object();
  json.key("utilisation").open_object();
  json.member("median", row.median);
  json.member("quantile", row.quantile);
  write_extreme(json, "largest", tally.worst);
  json.close_object();
  json.close_object();
}

/// The designs, each with its samples: `results` are medians, those of objectives quantiles.
void write_designs(JsonWriter& json, const SweepPlan& plan, const SweepStatistics& found) {
  const project::DesignCounts counts = found.design_counts();
  json.key("designs").open_object();
  json.member("samples", whole(found.designs().asked().samples));
  json.member("quantile", found.designs().asked().quantile);
  json.member("all_pass", whole(counts.all_pass));
  json.member("some_fail", whole(counts.some_fail));
  json.member("all_fail", whole(counts.all_fail));
  json.member("not_assessed", whole(counts.not_assessed));
  json.member("invalid", whole(counts.invalid));
  json.key("rows").open_array();
  for (const project::DesignRow& row : found.designs().rows()) write_row(json, plan, found, row);
  json.close_array();
  if (!found.designs().asked().aims.empty()) {
    json.key("pareto").open_array();
    for (const auto& point : found.designs().pareto()) {
      json.open_object();
      write_design(json, plan, found, point.index, point.values);
      json.close_object();
    }
    json.close_array();
  }
  json.close_object();
}

/// The demands on a Pareto set, with the number of designs, or points, that satisfy each.
void write_demands(JsonWriter& json, const SweepStatistics& found) {
  const auto& demands = found.keep().demands;
  if (demands.empty()) return;
  json.key("demands").open_object();
  json.key("each").open_array();
  for (std::size_t i = 0; i < demands.size(); ++i) {
    json.open_object();
    json.member("such_that", demands[i].text);
    json.member("met_by", whole(found.demands_met().of_each[i]));
    json.close_object();
  }
  json.close_array();
  json.member("all_met_by", whole(found.demands_met().all));
  json.close_object();
}

void write_correlations(JsonWriter& json, const SweepPlan& plan, const SweepStatistics& found) {
  const sweep::Covariances all = found.covariances();
  if (all.size() == 0 || plan.requested().empty()) return;
  json.key("correlations").open_object();
  for (std::size_t k = 0; k < plan.requested().size(); ++k) {
    json.key(plan.columns[k].name).open_object();
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
      json.member(plan.inputs[i].name, all.correlation(i, plan.inputs.size() + k));
    json.close_object();
  }
  json.close_object();
}

}  // namespace

std::string json_of(const project::Project& project, const SweepPlan& plan, const SweepStatistics& found,
                    std::string_view program) {
  JsonWriter json;
  json.open_object();
  json.member("program", program);
  json.member("project", project.file);
  json.member("points", whole(found.points()));
  json.member("seed", whole(project.sweep.seed));
  write_inputs(json, plan);
  json.key("results").open_array();
  for (std::size_t k = 0; k < plan.requested().size(); ++k) write_result(json, plan.columns[k], found.results()[k]);
  json.close_array();
  write_modes(json, project, plan, found);
  json.key("refused").open_array();
  for (const auto& [id, refused] : found.refusals()) {
    json.open_object();
    json.member("key", refused.key);
    json.member("message", refused.message);
    json.member("points", whole(refused.count));
    json.member("first", whole(refused.first));
    json.close_object();
  }
  json.close_array();
  write_demands(json, found);
  write_points(json, plan, found);
  if (plan.space.count() > plan.space.samples()) write_designs(json, plan, found);
  write_correlations(json, plan, found);
  json.close_object();
  return json.take();
}

}  // namespace loadpath::exports
