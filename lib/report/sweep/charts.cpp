#include "lib/report/sweep/charts.hpp"

#include "lib/figure/chart.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace loadpath::report {

namespace {

using figure::Chart;
using project::Project;
using project::SweepPlan;
using project::SweepStatistics;
using project::SweptInput;
using project::SweptResult;
using Verdict = Chart::Verdict;

/// The mode that decides the verdict of a point: the worst, and among equals the one with the highest utilisation.
struct Decided {
  Verdict verdict = Verdict::none;
  std::size_t tally = 0;  // 0: no mode; else as in SweepStatistics::tallies()
  double utilisation = std::nan("");
};

Verdict verdict_of(double state) {
  if (state == account::refused_state || std::isnan(state)) return Verdict::none;
  const auto s = static_cast<State>(static_cast<int>(state));
  if (s == State::fail) return Verdict::fails;
  return s == State::pass || s == State::accepted ? Verdict::passes : Verdict::open;
}

Decided decided(const SolvedPoints& points, std::size_t asked, std::size_t i) {
  Decided found{verdict_of(points.results[asked][i]), 0, points.results[asked + 1][i]};
  int worst = -1;
  double most = std::nan("");
  for (std::size_t t = 1; asked + 2 * t + 1 < points.results.size(); ++t) {
    const double state = points.results[asked + 2 * t][i], used = points.results[asked + 2 * t + 1][i];
    if (!(state >= 0.0) || state == account::refused_state) continue;
    const int rank = account::rank(static_cast<State>(static_cast<int>(state)));
    if (rank < worst || (rank == worst && !(used > most) && !(std::isnan(most) && !std::isnan(used)))) continue;
    worst = rank;
    most = used;
    found.tally = t;
  }
  return found;
}

std::string mode_name(const SweptResult& column) { return column.step + "." + column.mode; }

/// A chart with the data common to both kinds: shown values, state of each point.
Chart chart_of(const Project& project, const SweepPlan& plan, const SolvedPoints& points) {
  const std::size_t asked = plan.columns.size();
  const auto verdicts = project::verdict_columns(project);
  Chart chart;
  chart.points = points.numbers;
  chart.command = "loadpath run " + (project.file == "-" ? "FILE" : project.file) + " --point ";
  for (std::size_t k = 0; k < plan.inputs.size(); ++k)
    chart.readout.push_back({plan.inputs[k].name, plan.inputs[k].unit, points.inputs[k], plan.inputs[k].words});
  for (const std::size_t k : plan.output_columns())
    chart.readout.push_back({plan.columns[k].name, plan.columns[k].unit, points.results[k]});
  Chart::Column used{say("utilisation").text(), "-", points.results[asked + 1]}, said{say("verdict").text(), "", {}};
  std::map<std::size_t, std::size_t> modes;  // number of a mode in the chart
  std::map<std::string, std::size_t> words;
  const auto word = [&](const std::string& text) {
    const auto known = words.emplace(text, words.size());
    if (known.second) said.words.push_back(text);
    return static_cast<double>(known.first->second);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Decided how = decided(points, asked, i);
    Chart::Dot dot{0.0, 0.0, how.verdict, 0};
    const std::string mode = how.tally == 0 ? "" : mode_name(verdicts[2 * how.tally]);
    if (how.verdict == Verdict::fails) {
      const auto known = modes.emplace(how.tally, chart.modes.size());
      if (known.second) chart.modes.push_back(mode);
      dot.mode = known.first->second;
    }
    const std::string of_mode = mode.empty() ? "" : say(" by {1}", mode).text();
    said.si.push_back(how.verdict == Verdict::none     ? word(say("invalid design").text())
                      : how.verdict == Verdict::fails  ? word(say("fails{1}", of_mode).text())
                      : how.verdict == Verdict::passes ? word(say("passes").text())
                                                       : word(say("no result{1}", of_mode).text()));
    chart.dots.push_back(dot);
  }
  chart.readout.push_back(std::move(used));
  chart.readout.push_back(std::move(said));
  return chart;
}

/// A logarithmic scale for values over several decades.
figure::Scale scale_of(const SweptResult& column, const std::vector<double>& values) {
  constexpr double decades = 30.0;
  double least = INFINITY, most = 0.0;
  for (const double v : values) {
    if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  }
  return {column.name, "", column.unit, least > 0.0 && std::isfinite(least) && most > decades * least};
}

/// Equal ratios on a logarithmic scale.
figure::Scale scale_of(const SweptInput& input) {
  const std::uint64_t n = input.axis.size();
  const double first = input.axis.at(0), second = input.axis.at(1), last = input.axis.at(n - 1);
  const bool positive = first > 0.0 && last > 0.0 && n > 2;
  const double ratios = static_cast<double>(n - 1) * std::log(second / first);
  const bool equal_ratios = positive && std::abs(ratios - std::log(last / first)) < 1e-9 * std::abs(ratios);
  return {input.name, "", input.unit, equal_ratios};
}

std::size_t place_of(const std::vector<std::uint64_t>& numbers, std::uint64_t number) {
  return static_cast<std::size_t>(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
}

figure::Figure cloud_of(const Project& project, const SweepPlan& plan, const SweepStatistics& found,
                        const SolvedPoints& points) {
  const auto& objectives = found.keep().objectives;
  const std::size_t across = objectives[0].column, up = objectives[1].column;
  Chart chart = chart_of(project, plan, points);
  chart.x = scale_of(plan.columns[across], points.results[across]);
  chart.y = scale_of(plan.columns[up], points.results[up]);
  chart.more_x = objectives[0].aim == sweep::Aim::max;
  chart.more_y = objectives[1].aim == sweep::Aim::max;
  chart.steps = objectives.size() == 2;
  for (std::size_t i = 0; i < points.size(); ++i) {
    chart.dots[i].x = points.results[across][i];
    chart.dots[i].y = points.results[up][i];
  }
  const auto put = [&](std::uint64_t number, std::vector<std::size_t>& dots) {
    const std::size_t dot = place_of(points.numbers, number);
    if (dot < points.size() && points.numbers[dot] == number) dots.push_back(dot);
  };
  for (const auto& point : found.pareto()) put(point.index, chart.front);
  for (const auto& point : found.designs().pareto()) put(point.index * found.designs().asked().samples, chart.front);
  if (found.designs().asked().samples < 2) {
    for (const auto& point : found.worst()) put(point.index, chart.worst);
  }
  if (chart.more_x) std::reverse(chart.front.begin(), chart.front.end());
  chart.shown = chart.front.empty() ? 0 : chart.front[chart.front.size() / 2];
  const bool scatters = found.designs().asked().samples > 1;
  return {"cloud",
          scatters ? "Designs over the quantiles of two results, with the Pareto-optimal ones"
                   : "Points over two results, with the Pareto-optimal ones",
          std::make_shared<const Chart>(std::move(chart))};
}

bool any_number(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// The passing point with the highest utilisation.
std::size_t last_that_passes(const Chart& chart) {
  std::size_t found = 0;
  double most = -INFINITY;
  for (std::size_t i = 0; i < chart.dots.size(); ++i) {
    if (chart.dots[i].verdict == Verdict::passes && chart.levels[i] > most) most = chart.levels[found = i];
  }
  return found;
}

figure::Figure field_of(const Project& project, const SweepPlan& plan, const Plane& plane) {
  const std::size_t asked = plan.columns.size();
  Chart chart = chart_of(project, plan, plane.points);
  chart.x = scale_of(plan.inputs[plane.across]);
  chart.y = scale_of(plan.inputs[plane.up]);
  chart.columns = plane.columns;
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    chart.dots[i].x = plane.points.inputs[plane.across][i];
    chart.dots[i].y = plane.points.inputs[plane.up][i];
  }
  chart.levels = plane.points.results[asked + 1];
  chart.level = say("utilisation").text();
  chart.is_limited = any_number(chart.levels);
  if (!chart.is_limited) {  // modes that are met or not met
    chart.level = asked == 0 ? "" : plan.columns[0].name;
    if (asked > 0) chart.level_unit = plan.columns[0].unit;
    if (asked > 0) chart.levels = plane.points.results[0];
  }
  chart.shown = last_that_passes(chart);
  return {"plane", "Effect of two inputs: contour lines; hatched: fail",
          std::make_shared<const Chart>(std::move(chart))};
}

Paragraph drawn_of(const SolvedPoints& points, std::uint64_t all) {
  return {say("The figure has {1} of {2} points, spread evenly.", std::to_string(points.size()), std::to_string(all)),
          Paragraph::Tone::note};
}

}  // namespace

std::vector<Block> sweep_charts(const Project& project, const SweepPlan& plan, const SweepStatistics& found,
                                const DrawnPoints& drawn) {
  std::vector<Block> blocks;
  const bool scatters = found.designs().asked().samples > 1;
  if (drawn.cloud.size() > 0 && found.pareto().size() + found.designs().pareto().size() > 1) {
    blocks.emplace_back(cloud_of(project, plan, found, drawn.cloud));
    if (!scatters && drawn.cloud.size() < found.points()) blocks.emplace_back(drawn_of(drawn.cloud, found.points()));
  }
  if (drawn.plane) {
    blocks.emplace_back(field_of(project, plan, *drawn.plane));
    if (drawn.plane->points.size() < found.points()) blocks.emplace_back(drawn_of(drawn.plane->points, found.points()));
  }
  return blocks;
}

}  // namespace loadpath::report
