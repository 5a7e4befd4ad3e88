#include "lib/report/sweep/sweep.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/sweep/charts.hpp"
#include "lib/report/sweep/designs.hpp"
#include "lib/report/sweep/shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::report {

namespace {

using project::has_scattering_designs;
using project::Project;
using project::SweepPlan;
using project::SweepStatistics;
using project::SweptInput;
using project::SweptResult;
using project::Tally;

constexpr std::size_t most_rows = 12;  // rows of the Pareto set, on paper
constexpr std::size_t bins = 30;
constexpr std::size_t most_designs = 40;   // rows of designs, on paper
constexpr std::uint64_t most_listed = 12;  // values of an input

std::string number(std::uint64_t n) { return std::to_string(n); }

bool is_sample(const SweepPlan& plan) {
  return std::any_of(plan.inputs.begin(), plan.inputs.end(), [](const SweptInput& i) { return i.distribution; });
}

Quantity quantity(double si, const std::string& unit, int digits = 4) {
  return {si, unit.empty() ? std::string("-") : unit, digits};
}

/// All values: "20 mm, 25 mm, 32 mm"; of many words the first ones, and how many there are.
std::string listed(const SweptInput& input, std::uint64_t n) {
  std::string all;
  for (std::uint64_t i = 0; i < std::min(n, most_listed); ++i)
    all += (all.empty() ? "" : ", ") + written(input, input.words.empty() ? input.axis.at(i) : static_cast<double>(i));
  return n <= most_listed ? all : all + "... " + say("{1} of them", number(n)).text();
}

/// The values of an input: "20 mm, 25 mm, 32 mm"; "20 mm to 60 mm, 41 values"; "normal, mean 200 N*m, sd 20 N*m".
Message course_of(const SweptInput& input) {
  if (!input.distribution) {
    const std::uint64_t n = input.words.empty() ? input.axis.size() : input.words.size();
    if (n <= most_listed || !input.words.empty()) return say("{1}", listed(input, n));
    return say("{1} to {2}, {3} values", written(input, input.axis.at(0)), written(input, input.axis.at(n - 1)),
               number(n));
  }
  static constexpr std::array names{"normal", "uniform", "triangular", "lognormal", "Weibull"};
  return say("{1}, mean {2}, standard deviation {3}", names[input.distribution->law().index()],
             written(input, input.distribution->mean()), format_quantity(input.distribution->sd(), input.unit, 4));
}

Table input_table(const SweepPlan& plan) {
  Table table{say("Inputs"), {say("input"), say("values")}, {}};
  for (const SweptInput& input : plan.inputs) table.rows.push_back({input.name, course_of(input)});
  return table;
}

/// The number of a point where there is a value.
Cell point_of(const sweep::Extreme& extreme) {
  return std::isnan(extreme.value) ? std::string("-") : number(extreme.index);
}

Table result_table(const SweepPlan& plan, const SweepStatistics& found) {
  Table table{say("Results"),
              {say("result"), say("mean"), say("sd"), say("least"), say("at point"), say("5 %"), say("median"),
               say("95 %"), say("largest"), say("at point")},
              {}};
  for (std::size_t k = 0; k < plan.requested().size(); ++k) {
    const SweptResult& column = plan.columns[k];
    const sweep::Summary& summary = found.results()[k];
    const sweep::Moments moments = summary.moments();
    const sweep::Ranks ranks = summary.ranks();
    const auto shown = [&](double si) { return quantity(si, column.unit); };
    table.rows.push_back({column.name, shown(moments.mean()), shown(moments.sd()), shown(summary.min().value),
                          point_of(summary.min()), shown(ranks.quantile(0.05)), shown(ranks.quantile(0.5)),
                          shown(ranks.quantile(0.95)), shown(summary.max().value), point_of(summary.max())});
  }
  return table;
}

/// Points of designs that are valid: the denominator of all shares. A sample that violates a rule is a failure of its
/// design.
std::uint64_t valid_points(const SweepStatistics& found) {
  return found.tallies().front().total() - found.points_of_invalid();
}

/// The results that have a value at points of invalid designs: "passes" is 0 there.
std::optional<Paragraph> with_invalid_points(const SweepPlan& plan, const SweepStatistics& found) {
  std::string names;
  for (std::size_t k = 0; k < plan.requested().size(); ++k) {
    if (found.results()[k].count() > valid_points(found)) names += (names.empty() ? "" : ", ") + plan.columns[k].name;
  }
  if (names.empty()) return std::nullopt;
  return Paragraph{say("Points of invalid designs are included in table and histogram of: {1}.", names),
                   Paragraph::Tone::note};
}

/// The name of a mode, from that of its column: "shaft.yield" of "shaft.modes.yield.state".
std::string mode_name(const SweptResult& column) { return column.step + "." + column.mode; }

Table mode_table(const Project& project, const SweepPlan& plan, const SweepStatistics& found) {
  Table table{say("Failure modes"),
              {say("mode"), say("fails"), say("no result"), say("passes"), say("largest utilisation"), say("at point")},
              {}};
  const auto columns = project::verdict_columns(project);
  const std::uint64_t n = valid_points(found);
  for (std::size_t t = 1; t < found.tallies().size(); ++t) {
    const Tally& tally = found.tallies()[t];
    const std::uint64_t concerned = tally.total() - tally.refused_points(), fails = tally.of(State::fail);
    if (concerned == 0) continue;
    const std::uint64_t gaps = concerned - fails - tally.passing();
    const bool remote = fails == 0 && gaps == 0 && tally.of(State::open) == concerned;
    if (remote) continue;  // reported at the end of a run of one point
    table.rows.push_back(
        {mode_name(columns[2 * t]), share_text(fails, n, is_sample(plan)), share_text(gaps, n, false),
         share_text(tally.passing(), n, false),
         std::isnan(tally.largest.value) ? Cell(std::string("-")) : Cell(quantity(tally.largest.value, "-")),
         point_of(tally.largest)});
  }
  return table;
}

Table refused_table(const SweepStatistics& found) {
  Table table{say("Invalid designs"), {say("why"), say("points"), say("first")}, {}};
  for (const auto& [id, refused] : found.refusals())
    table.rows.push_back({refused.key + ": " + refused.message, number(refused.count), number(refused.first)});
  return table;
}

std::vector<Cell> row_of_point(const SweepPlan& plan, std::uint64_t index, const std::vector<double>& values) {
  std::vector<Cell> row{number(index)};
  const std::size_t inputs = plan.inputs.size();
  for (std::size_t i = 0; i < inputs; ++i) row.emplace_back(written(plan.inputs[i], values[i]));
  for (const std::size_t k : plan.output_columns())
    row.emplace_back(quantity(values[inputs + k], plan.columns[k].unit, 5));
  return row;
}

Table table_of_points(const SweepPlan& plan, Message caption) {
  Table table{std::move(caption), {say("point")}, {}};
  for (const SweptInput& input : plan.inputs) table.head.push_back(say("{1}", input.name));
  for (const std::size_t k : plan.output_columns()) table.head.push_back(say("{1}", plan.columns[k].name));
  return table;
}

Table worst_table(const SweepPlan& plan, const SweepStatistics& found) {
  Table table = table_of_points(plan, say("Points with the largest utilisation"));
  table.head.insert(table.head.begin() + 1, say("utilisation"));
  for (const auto& worst : found.worst()) {
    auto row = row_of_point(plan, worst.index, worst.values);
    row.insert(row.begin() + 1, quantity(worst.key, "-"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table pareto_table(const SweepPlan& plan, const SweepStatistics& found) {
  const auto points = found.pareto();
  Message caption = points.size() > most_rows
                        ? say("Pareto set: {1} points, {2} of them", number(points.size()), number(most_rows))
                        : say("Pareto set: {1} points", number(points.size()));
  if (!found.keep().demands.empty())
    caption = say("{1}, of those that satisfy {2}", std::move(caption), demands_in_words(found));
  Table table = table_of_points(plan, std::move(caption));
  const std::size_t shown = std::min(points.size(), most_rows);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t which = shown == points.size() ? i : i * (points.size() - 1) / (shown - 1);
    table.rows.push_back(row_of_point(plan, points[which].index, points[which].values));
  }
  return table;
}

/// The share of each uncertain input in the scatter of a result, if they are uncorrelated and act linearly.
std::optional<Table> correlation_table(const SweepPlan& plan, const SweepStatistics& found) {
  const sweep::Covariances all = found.covariances();
  if (!is_sample(plan) || plan.requested().empty() || all.size() == 0) return std::nullopt;
  Table table{say("Correlation of inputs and results"), {say("input")}, {}};
  for (const SweptResult& column : plan.requested()) table.head.push_back(say("{1}", column.name));
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    std::vector<Cell> row{plan.inputs[i].name};
    for (std::size_t k = 0; k < plan.requested().size(); ++k) {
      const double r = all.correlation(i, plan.inputs.size() + k);
      row.emplace_back(std::isnan(r) ? std::string("-") : format_number(r, 3));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Bars of a histogram as one line.
figure::Figure histogram_of(const SweptResult& column, const sweep::Summary& summary, std::size_t number_of_column) {
  const sweep::Histogram histogram = summary.ranks().histogram(bins);
  figure::Plot plot(figure::Scale{column.name, "", column.unit},
                    figure::Scale{"", "share of the points in a class", "%"});
  figure::Curve curve;
  curve.filled = true;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const double share = static_cast<double>(histogram.counts[i]) / static_cast<double>(summary.count());
    for (const double x : {histogram.edges[i], histogram.edges[i + 1]}) {
      curve.x.push_back(x);
      curve.y.push_back(share);
    }
  }
  curve.x.insert(curve.x.begin(), curve.x.front());
  curve.y.insert(curve.y.begin(), 0.0);
  curve.x.push_back(curve.x.back());
  curve.y.push_back(0.0);
  plot.curves.push_back(std::move(curve));
  return {"histogram-" + number(number_of_column + 1), say("Histogram: {1}", column.name).text(), std::move(plot)};
}

Paragraph conclusion(const SweepPlan& plan, const SweepStatistics& found) {
  const Tally& all = found.tallies().front();
  const std::uint64_t invalid = found.points_of_invalid(), refused = all.refused_points() - invalid;
  const std::uint64_t n = valid_points(found), fails = all.of(State::fail) + refused;
  const std::uint64_t gaps = n - fails - all.passing();
  std::string text = number(n) + (n == 1 ? " point: " : " points: ") + number(all.passing()) + " pass, " +
                     share_text(all.passing(), n, is_sample(plan)) + "; " + number(fails) + " fail";
  if (gaps > 0) text += "; " + number(gaps) + " are not assessed, have no valid method or no result";
  if (refused > 0) text += ", " + number(refused) + " of them because a sample violates an input rule";
  text += ".";
  if (invalid > 0) text += " " + number(invalid) + " points of invalid designs are left out.";
  if (plan.inputs.empty()) text += " Nothing varies: the single design of the project.";
  return {say("{1}", text), Paragraph::Tone::plain};
}

}  // namespace

Document sweep_document(const Project& project, const SweepPlan& plan, const SweepStatistics& found,
                        std::string_view program, const DrawnPoints& drawn) {
  Document document;
  document.title = project.title.empty() ? project.file : project.title;
  document.meta.emplace_back(say("Project file"), project.file);
  for (const auto& [key, value] : project.meta) document.meta.emplace_back(say("{1}", capitalised(spoken(key))), value);
  document.meta.emplace_back(say("Points"), number(found.points()));
  if (is_sample(plan)) document.meta.emplace_back(say("Seed"), number(project.sweep.seed));
  document.program = program;
  document.meta.emplace_back(say("Program"), document.program);
  auto& blocks = document.blocks;
  blocks.emplace_back(Heading{2, "Sweep", "sweep"});
  const auto headline = project::headline_of(plan, found);
  if (has_scattering_designs(plan) || (headline && *headline != account::Headline::pass))
    blocks.emplace_back(Paragraph{say("{1}.", count_of_designs(plan, found)), Paragraph::Tone::plain});
  blocks.emplace_back(conclusion(plan, found));
  if (auto chosen = chosen_design(plan, found)) blocks.emplace_back(std::move(*chosen));
  for (Block& block : sweep_charts(project, plan, found, drawn)) blocks.push_back(std::move(block));
  if (!plan.inputs.empty()) blocks.emplace_back(input_table(plan));
  if (!plan.requested().empty()) blocks.emplace_back(result_table(plan, found));
  if (auto included = with_invalid_points(plan, found)) blocks.emplace_back(std::move(*included));
  blocks.emplace_back(mode_table(project, plan, found));
  if (!found.refusals().empty()) blocks.emplace_back(refused_table(found));
  if (has_scattering_designs(plan)) blocks.emplace_back(design_table(plan, found, most_designs));
  if (!found.worst().empty()) blocks.emplace_back(worst_table(plan, found));
  const bool scatters = has_scattering_designs(plan);
  if (auto unmet = unmet_demands(found))
    blocks.emplace_back(std::move(*unmet));
  else if (!found.keep().objectives.empty())
    blocks.emplace_back(scatters ? front_of_designs(plan, found) : pareto_table(plan, found));
  if (auto table = correlation_table(plan, found)) blocks.emplace_back(std::move(*table));
  for (std::size_t k = 0; k < plan.requested().size(); ++k) {
    if (found.results()[k].count() > 1 && found.results()[k].min().value < found.results()[k].max().value)
      blocks.emplace_back(histogram_of(plan.columns[k], found.results()[k], k));
  }
  return document;
}

}  // namespace loadpath::report
