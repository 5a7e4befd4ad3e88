#include "lib/report/sweep/designs.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/sweep/shares.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {

namespace {

using project::DesignRow;
using project::DesignTally;
using project::has_scattering_designs;
using project::Project;
using project::SweepPlan;
using project::SweepStatistics;
using project::SweptInput;

constexpr std::size_t most_in_answer = 8, most_in_front = 12;

std::string number(std::uint64_t n) { return std::to_string(n); }

/// The inputs that distinguish the designs.
std::vector<std::size_t> chosen_inputs(const SweepPlan& plan) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    if (!plan.inputs[i].distribution) chosen.push_back(i);
  }
  return chosen;
}

bool scatters(const SweepStatistics& found) { return found.designs().asked().samples > 1; }

std::vector<double> values_of(const SweepPlan& plan, const SweepStatistics& found, std::uint64_t design) {
  return plan.at(design * found.designs().asked().samples);
}

/// "d = 50 mm, d_bore = 45 mm".
std::string described(const SweepPlan& plan, const SweepStatistics& found, const DesignRow& row) {
  const std::vector<double> values = values_of(plan, found, row.design);
  std::string all;
  for (const std::size_t i : chosen_inputs(plan))
    all += (all.empty() ? "" : ", ") + plan.inputs[i].name + " = " + written(plan.inputs[i], values[i]);
  for (const std::size_t k : plan.output_columns()) {
    const bool is_first = k == plan.output_columns().front();
    if (is_first)
      all += (all.empty() ? "" : ", ") + plan.columns[k].name + " = " +
             format_quantity(row.results[k], plan.columns[k].unit, 4);
  }
  return all;
}

Cell number_or_dash(double value) { return std::isnan(value) ? Cell(std::string("-")) : Cell(Quantity{value, "-", 3}); }

std::vector<Message> heads(const SweepPlan& plan, const SweepStatistics& found) {
  std::vector<Message> head;
  for (const std::size_t i : chosen_inputs(plan)) head.push_back(say("{1}", plan.inputs[i].name));
  for (const std::size_t k : plan.output_columns()) head.push_back(say("{1}", plan.columns[k].name));
  if (!scatters(found)) {
    for (const Message& last : {say("verdict"), say("utilisation"), say("point")}) head.push_back(last);
    return head;
  }
  const std::string level = format_number(100.0 * found.designs().asked().quantile, 6) + " %";
  for (const Message& last : {say("fails (95 %)"), say("median"), say("{1}", level), say("worst"), say("at point")})
    head.push_back(last);
  return head;
}

/// The verdict of a design without scatter.
std::string verdict_of(const DesignTally& tally) {
  return tally.passing > 0 ? "pass" : tally.failing > 0 ? "fail" : "not assessed";
}

std::vector<Cell> cells_of(const SweepPlan& plan, const SweepStatistics& found, const DesignRow& row) {
  std::vector<Cell> cells;
  const std::vector<double> values = values_of(plan, found, row.design);
  for (const std::size_t i : chosen_inputs(plan)) cells.emplace_back(written(plan.inputs[i], values[i]));
  for (const std::size_t k : plan.output_columns()) {
    const std::string& unit = plan.columns[k].unit;
    cells.emplace_back(Quantity{row.results[k], unit.empty() ? std::string("-") : unit, 4});
  }
  const DesignTally& tally = row.tally;
  const Cell at = std::isnan(tally.worst.value) ? Cell(std::string("-")) : Cell(number(tally.worst.index));
  if (!scatters(found)) {
    cells.emplace_back(verdict_of(tally));
    cells.push_back(number_or_dash(tally.worst.value));
    cells.emplace_back(number(row.design));
    return cells;
  }
  cells.emplace_back(share_text(tally.failing, tally.samples, true));
  for (const double value : {row.median, row.quantile, tally.worst.value}) cells.push_back(number_or_dash(value));
  cells.push_back(at);
  return cells;
}

Paragraph plain(std::string text) { return {say("{1}", std::move(text)), Paragraph::Tone::plain}; }
Paragraph note(Message text) { return {std::move(text), Paragraph::Tone::note}; }

/// "Scatter: P normal 40 kN ± 4 kN, ...; 200 samples of each design".
Message scatter_of(const SweepPlan& plan, std::uint64_t samples) {
  std::string all;
  for (const SweptInput& input : plan.inputs) {
    if (!input.distribution) continue;
    all += (all.empty() ? "" : ", ") + input.name + " " + written(input, input.distribution->mean()) + " (sd " +
           format_quantity(input.distribution->sd(), input.unit, 3) + ")";
  }
  return say("Scatter: {1}; {2} samples of each design", all, number(samples));
}

/// The failure share that no failure in n samples still leaves possible, and the samples for 0.1 %.
Message resolution_of(std::uint64_t samples) {
  const double most = sweep::share_bounds(0, samples, confidence_of_shares).high;
  constexpr double wanted = 0.001;
  const double needed = std::ceil(std::log(0.5 * (1.0 - confidence_of_shares)) / std::log1p(-wanted));
  return say("0 of {1} shows a failure share below {2}; for below 0.1 % use --samples {3}", number(samples),
             in_percent(most), format_number(needed, 6));
}

/// A quantile that so few samples do not bound with the usual confidence: none of them may lie beyond it.
Message doubt_of_quantile(std::uint64_t samples, double quantile) {
  const double doubt = 1.0 - confidence_of_shares;
  const double needed = std::ceil(std::log(doubt) / std::log(quantile));
  if (static_cast<double>(samples) >= needed) return {};
  const double shown = std::pow(doubt, 1.0 / static_cast<double>(samples));
  return say("{1} samples bound the {2} % quantile with 95 % confidence, not that of {3} %: use --samples {4}",
             number(samples), format_number(100.0 * shown, 3), format_number(100.0 * quantile, 6),
             format_number(needed, 6));
}

/// The mode with the most failures over the designs.
Message governing_of(const Project& project, const SweepStatistics& found) {
  const auto columns = project::verdict_columns(project);
  std::size_t worst = 0;
  std::uint64_t all = found.tallies().front().of(account::State::fail);
  for (std::size_t t = 1; t < found.tallies().size(); ++t) {
    const bool is_more =
        worst == 0 || found.tallies()[t].of(account::State::fail) > found.tallies()[worst].of(account::State::fail);
    if (is_more) worst = t;
  }
  const std::uint64_t fails = worst == 0 ? 0 : found.tallies()[worst].of(account::State::fail);
  if (fails == 0) return {};
  const auto& column = columns[2 * worst];
  return say("Governing failure mode: {1}.{2}, in {3} of {4} failures", column.step, column.mode, number(fails),
             number(all));
}

std::string of_scattering(const SweepStatistics& found) {
  const project::DesignCounts counts = found.design_counts();
  std::string text = number(counts.all_pass) + " of " + number(counts.valid()) + " designs pass in all " +
                     number(found.designs().asked().samples) + " samples";
  if (counts.some_fail > 0) text += "; " + number(counts.some_fail) + " fail in some";
  if (counts.all_fail > 0)
    text += (counts.some_fail > 0 ? ", " : "; ") + number(counts.all_fail) +
            (counts.some_fail > 0 ? " in all" : " fail in all");
  if (counts.not_assessed > 0) text += "; " + number(counts.not_assessed) + " not assessed";
  return text;
}

Message caption_of_front(const SweepStatistics& found, std::size_t size) {
  const std::string demands = demands_in_words(found);
  const Message designs =
      demands.empty() ? say("Pareto set of the designs") : say("Pareto set of the designs that satisfy {1}", demands);
  if (!scatters(found)) return say("{1}: {2}", designs, number(size));
  return say("{1} at {2}: {3}", designs, format_number(100.0 * found.designs().asked().quantile, 6) + " %",
             number(size));
}

/// Of the columns behind the results.
Message caption_of(std::size_t rows, std::size_t most, bool scatters) {
  const Message designs = rows <= most ? say("Designs") : say("Designs: the first {1}", number(most));
  return scatters ? say("{1}; failure share with 95 % bounds, utilisation of the samples", designs) : designs;
}

}  // namespace

std::string count_of_designs(const SweepPlan& plan, const SweepStatistics& found) {
  const project::DesignCounts counts = found.design_counts();
  const auto headline = project::headline_of(plan, found);
  std::string text = headline && *headline != account::Headline::pass ? std::string(word(*headline)) + ": " : "";
  if (counts.valid() == 0 && counts.invalid > 0)
    return text + "none of the " + number(counts.invalid) + " designs is valid";
  if (has_scattering_designs(plan)) return text + of_scattering(found);
  text += number(counts.all_pass) + " of " + number(counts.valid()) + " designs pass";
  if (counts.all_fail > 0) text += "; " + number(counts.all_fail) + " fail";
  if (counts.not_assessed > 0) text += "; " + number(counts.not_assessed) + " not assessed";
  return text;
}

Table design_table(const SweepPlan& plan, const SweepStatistics& found, std::size_t most) {
  const std::vector<DesignRow> rows = found.designs().rows();
  Table table{caption_of(rows.size(), most, scatters(found)), heads(plan, found), {}};
  for (std::size_t i = 0; i < std::min(rows.size(), most); ++i) table.rows.push_back(cells_of(plan, found, rows[i]));
  return table;
}

std::string demands_in_words(const SweepStatistics& found) {
  std::string all;
  for (const project::SweptDemand& demand : found.keep().demands)
    all += (all.empty() ? "'" : ", '") + demand.text + "'";
  return all;
}

std::optional<Paragraph> unmet_demands(const SweepStatistics& found) {
  const auto& demands = found.keep().demands;
  if (demands.empty() || found.demands_met().all > 0) return std::nullopt;
  std::string each;
  const project::DesignCounts counts = found.design_counts();
  for (std::size_t i = 0; i < demands.size(); ++i)
    each += (each.empty() ? "'" : ", '") + demands[i].text + "' by " + number(found.demands_met().of_each[i]);
  return Paragraph{say("None of {1} designs satisfies all demands: {2}", number(counts.valid()), each),
                   Paragraph::Tone::warning};
}

Table front_of_designs(const SweepPlan& plan, const SweepStatistics& found) {
  const auto front = scatters(found) ? found.designs().pareto() : found.pareto();
  const std::size_t before = scatters(found) ? 0 : plan.inputs.size();  // values before the results
  Table table{caption_of_front(found, front.size()), {}, {}};
  for (const std::size_t i : chosen_inputs(plan)) table.head.push_back(say("{1}", plan.inputs[i].name));
  for (const std::size_t k : plan.output_columns()) table.head.push_back(say("{1}", plan.columns[k].name));
  for (std::size_t i = 0; i < std::min(front.size(), most_in_front); ++i) {
    const std::vector<double> values = values_of(plan, found, front[i].index);
    std::vector<Cell> cells;
    for (const std::size_t k : chosen_inputs(plan)) cells.emplace_back(written(plan.inputs[k], values[k]));
    for (const std::size_t k : plan.output_columns()) {
      const std::string& unit = plan.columns[k].unit;
      cells.emplace_back(Quantity{front[i].values[before + k], unit.empty() ? std::string("-") : unit, 4});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::optional<Paragraph> chosen_design(const SweepPlan& plan, const SweepStatistics& found) {
  const std::vector<DesignRow> rows = found.designs().rows();
  const bool any = !rows.empty() && rows.front().tally.passing == rows.front().tally.samples;
  if (!any || plan.output_columns().empty()) return std::nullopt;
  return plain("Least " + plan.columns[plan.output_columns().front()].name +
               " of those that always pass: " + described(plan, found, rows.front()));
}

std::vector<Block> sweep_answer(const Project& project, const SweepPlan& plan, const SweepStatistics& found) {
  std::vector<Block> blocks;
  const auto& designs = found.designs();
  blocks.emplace_back(plain(count_of_designs(plan, found)));
  if (auto chosen = chosen_design(plan, found)) blocks.emplace_back(std::move(*chosen));
  blocks.emplace_back(design_table(plan, found, most_in_answer));
  const std::uint64_t valid = found.design_counts().valid();
  if (valid > most_in_answer)
    blocks.emplace_back(note(say("{1} more designs: --full, --csv FILE", number(valid - most_in_answer))));
  if (scatters(found)) {
    blocks.emplace_back(note(scatter_of(plan, designs.asked().samples)));
    blocks.emplace_back(note(resolution_of(designs.asked().samples)));
    if (Message doubt = doubt_of_quantile(designs.asked().samples, designs.asked().quantile); !doubt.empty())
      blocks.emplace_back(Paragraph{std::move(doubt), Paragraph::Tone::warning});
  }
  for (const auto& [id, refused] : found.refusals())
    blocks.emplace_back(note(say("Invalid: {1} of {2} points, {3}: {4}", number(refused.count), number(found.points()),
                                 refused.key, refused.message)));
  if (const Message governing = governing_of(project, found); !governing.empty()) blocks.emplace_back(note(governing));
  if (found.keep().objectives.empty()) return blocks;
  if (auto unmet = unmet_demands(found))
    blocks.emplace_back(std::move(*unmet));
  else
    blocks.emplace_back(front_of_designs(plan, found));
  return blocks;
}

std::optional<std::uint64_t> point_of_answer(const SweepStatistics& found) {
  if (found.worst().empty()) return std::nullopt;
  const std::vector<DesignRow> rows = found.designs().rows();
  const auto front = scatters(found) ? found.designs().pareto() : found.pareto();
  if (front.empty() && rows.empty()) return found.worst().front().index;
  const std::uint64_t design = front.empty() ? rows.front().design : front.front().index;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const DesignRow& r) { return r.design == design; });
  const bool is_known = scatters(found) && row != rows.end() && !std::isnan(row->tally.worst.value);
  return is_known ? row->tally.worst.index : design * found.designs().asked().samples;
}

}  // namespace loadpath::report
