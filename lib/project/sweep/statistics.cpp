#include "lib/project/sweep/statistics.hpp"

#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using sweep::Reader;
using sweep::Writer;

constexpr std::size_t most_correlated = 24;  // columns: their products grow with the square

void put(Writer& writer, const std::string& text) {
  writer.put(std::uint64_t{text.size()});
  for (const char c : text) writer.put(std::uint64_t{static_cast<unsigned char>(c)});
}

std::string text_from(Reader& reader) {
  std::string text;
  for (std::uint64_t left = reader.count(1); left > 0; --left) text += static_cast<char>(reader.number());
  return text;
}

std::vector<sweep::Aim> aims_of(const Keep& keep) {
  std::vector<sweep::Aim> aims;
  for (const Objective& objective : keep.objectives) aims.push_back(objective.aim);
  return aims;
}

/// The values of a point: inputs, then results.
std::vector<double> row_of(const SolvedBlock& block, std::size_t results, std::size_t i) {
  std::vector<double> row;
  for (const auto& column : block.inputs) row.push_back(column[i]);
  for (std::size_t k = 0; k < results; ++k) row.push_back(block.results[k][i]);
  return row;
}

/// Of points if each is a design of its own.
DesignsRequest asked_of(std::size_t results, std::size_t verdicts, std::uint64_t samples, const Keep& keep) {
  DesignsRequest asked{.samples = samples, .results = results, .modes = verdicts / 2 - 1, .quantile = keep.quantile};
  if (samples < 2) return asked;
  for (const Objective& objective : keep.objectives) asked.columns.push_back(objective.column);
  asked.aims = aims_of(keep);
  asked.demands = keep.demands;
  return asked;
}

}  // namespace

/// A block has few states, most have one.
void Tally::add(std::uint64_t first, std::span<const double> state, std::span<const double> utilisation) {
  std::size_t left = state.size();
  const auto count = [&](double which) {
    const double found = sweep::count_of(which, state);
    if (which >= 0.0) counts[static_cast<std::size_t>(which)] += static_cast<std::uint64_t>(found);
    left -= static_cast<std::size_t>(found);
  };
  const double front = state.front();
  count(front);
  for (double which = account::absent_state; left > 0 && which < static_cast<double>(states); ++which) {
    if (which != front) count(which);
  }
  const double here = sweep::largest_of(utilisation);
  if (here == -INFINITY || here <= largest.value) return;  // there is none, or the first of equal ones is known
  for (std::size_t i = 0; i < utilisation.size(); ++i) largest.take(utilisation[i], first + i);
}

void Tally::merge(const Tally& other) {
  for (std::size_t i = 0; i < states; ++i) counts[i] += other.counts[i];
  largest.take(other.largest.value, other.largest.index);
}

std::uint64_t Tally::total() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts) sum += count;
  return sum;
}

std::uint64_t Tally::passing() const {
  std::uint64_t sum = 0;
  for (const account::State state : passing_states) sum += of(state);
  return sum;
}

SweepStatistics::SweepStatistics(std::size_t inputs, std::size_t results, std::size_t verdicts, std::uint64_t samples,
                                 Keep keep)
    : keep_(std::move(keep)),
      results_(results),
      tallies_(verdicts / 2),
      worst_(keep_.worst),
      pareto_(keep_.objectives.empty() || samples > 1 ? sweep::Pareto() : sweep::Pareto(aims_of(keep_))),
      demands_met_(keep_.demands.size()),
      designs_(asked_of(results, verdicts, samples, keep_)) {
  if (inputs + results > most_correlated) covariances_ = {};
}

void SweepStatistics::add(const SolvedBlock& block) {
  const std::size_t n = results_.size();
  const std::uint64_t number = block.first / block_size;
  points_ += block.count;
  for (std::size_t k = 0; k < n; ++k) results_[k].add(number, block.first, block.results[k]);
  for (std::size_t t = 0; t < tallies_.size(); ++t)
    tallies_[t].add(block.first, block.results[n + 2 * t], block.results[n + 2 * t + 1]);
  for (const Refusal& refusal : block.refusals) {
    Refused& alike = refusals_[std::string(refusal.issue.message.id)];
    if (alike.count++ == 0 || block.first + refusal.row < alike.first)
      alike = {alike.count, block.first + refusal.row, refusal.issue.key, refusal.issue.message.text()};
  }
  const auto row = [&](std::size_t i) { return row_of(block, n, i); };
  worst_.add(block.first, block.results[n + 1], row);
  designs_.add(block);
  if (!keep_.objectives.empty() && designs_.asked().samples < 2) add_to_front(block);
  std::vector<const double*> columns;
  for (const auto& column : block.inputs) columns.push_back(column.data());
  for (std::size_t k = 0; k < n; ++k) columns.push_back(block.results[k].data());
  if (columns.size() <= most_correlated) covariances_.add(number, sweep::Covariances(columns, block.count));
}

/// A point that does not satisfy a demand has no objective.
void SweepStatistics::add_to_front(const SolvedBlock& block) {
  std::vector<const double*> objectives;
  for (const Objective& objective : keep_.objectives) objectives.push_back(block.results[objective.column].data());
  std::vector<double> demanded;
  if (!keep_.demands.empty()) {
    demanded = block.results[keep_.objectives.front().column];
    objectives.front() = demanded.data();
  }
  for (std::size_t i = 0; i < demanded.size(); ++i) {
    bool all = true;
    for (std::size_t k = 0; k < keep_.demands.size(); ++k) {
      const bool is_met = keep_.demands[k].is_met(block.results[keep_.demands[k].column][i]);
      demands_met_.of_each[k] += is_met ? 1U : 0U;
      all = all && is_met;
    }
    demands_met_.all += all ? 1U : 0U;
    if (!all) demanded[i] = NAN;
  }
  pareto_.add(block.first, objectives, block.count, [&](std::size_t i) { return row_of(block, results_.size(), i); });
}

DesignCounts SweepStatistics::design_counts() const {
  if (designs_.asked().samples != 1) return designs_.counts();
  const Tally& points = tallies_.front();
  DesignCounts counts{.all_pass = points.passing(), .all_fail = points.of(account::State::fail)};
  counts.invalid = points.refused_points();
  counts.not_assessed = points.total() - counts.all_pass - counts.all_fail - counts.invalid;
  return counts;
}

std::uint64_t SweepStatistics::points_of_invalid() const {
  return design_counts().invalid * std::max<std::uint64_t>(designs_.asked().samples, 1);
}

std::optional<account::Headline> headline_of(const SweepPlan& plan, const SweepStatistics& found) {
  using account::Headline;
  const std::uint64_t samples = found.designs().asked().samples;
  if (samples == 0 || found.points() != plan.space.count()) return std::nullopt;
  const double needed = found.designs().asked().quantile * static_cast<double>(samples);
  Headline best = Headline::fail;
  for (const DesignRow& row : found.designs().rows()) {
    if (static_cast<double>(row.tally.passing) >= needed) return Headline::pass;
    if (static_cast<double>(row.tally.samples - row.tally.failing) >= needed) best = Headline::incomplete;
  }
  return best;
}

bool SweepStatistics::merge(const SweepStatistics& other) {
  for (std::size_t k = 0; k < results_.size(); ++k) {
    if (!results_[k].merge(other.results_[k])) return false;
  }
  if (!covariances_.merge(other.covariances_)) return false;
  points_ += other.points_;
  for (std::size_t t = 0; t < tallies_.size(); ++t) tallies_[t].merge(other.tallies_[t]);
  for (const auto& [id, theirs] : other.refusals_) {
    Refused& ours = refusals_[id];
    const std::uint64_t count = ours.count + theirs.count;
    if (ours.count == 0 || theirs.first < ours.first) ours = theirs;
    ours.count = count;
  }
  worst_.merge(other.worst_);
  pareto_.merge(other.pareto_);
  demands_met_.merge(other.demands_met_);
  designs_.merge(other.designs_);
  return true;
}

void SweepStatistics::store(Writer& writer) const {
  writer.put(points_);
  for (const sweep::Summary& result : results_) result.store(writer);
  for (const Tally& tally : tallies_) {
    for (const std::uint64_t count : tally.counts) writer.put(count);
    writer.put(tally.largest.value);
    writer.put(tally.largest.index);
  }
  writer.put(std::uint64_t{refusals_.size()});
  for (const auto& [id, refused] : refusals_) {
    put(writer, id);
    writer.put(refused.count);
    writer.put(refused.first);
    put(writer, refused.key);
    put(writer, refused.message);
  }
  worst_.store(writer);
  pareto_.store(writer);
  demands_met_.store(writer);
  designs_.store(writer);
  covariances_.store(writer);
}

void SweepStatistics::load(Reader& reader) {
  points_ = reader.number();
  for (sweep::Summary& result : results_) result.load(reader);
  for (Tally& tally : tallies_) {
    for (std::uint64_t& count : tally.counts) count = reader.number();
    tally.largest.value = reader.real();
    tally.largest.index = reader.number();
  }
  refusals_.clear();
  for (std::uint64_t left = reader.count(5); left > 0; --left) {
    const std::string id = text_from(reader);
    Refused& refused = refusals_[id];
    refused.count = reader.number();
    refused.first = reader.number();
    refused.key = text_from(reader);
    refused.message = text_from(reader);
  }
  worst_.load(reader);
  pareto_.load(reader);
  demands_met_.load(reader);
  designs_.load(reader);
  covariances_.load(reader);
}

}  // namespace loadpath::project
