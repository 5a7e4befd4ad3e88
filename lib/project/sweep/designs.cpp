#include "lib/project/sweep/designs.hpp"

#include "lib/account/fold.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::project {

namespace {

using account::State;
using sweep::Reader;
using sweep::Writer;

bool passes(double state) {
  return std::any_of(passing_states.begin(), passing_states.end(),
                     [&](State passing) { return state == account::number(passing); });
}

std::uint64_t count_in(std::span<const double> states, double state) {
  return static_cast<std::uint64_t>(sweep::count_of(state, states));
}

/// The samples by their outcome only.
DesignTally outcomes_of(std::span<const double> states) {
  DesignTally tally;
  tally.samples = states.size();
  for (const State state : passing_states) tally.passing += count_in(states, account::number(state));
  if (tally.passing == tally.samples) return tally;
  tally.refused = count_in(states, account::refused_state);
  tally.failing = tally.refused + count_in(states, account::number(State::fail));
  return tally;
}

/// The value of a column that is the same everywhere; NaN counts as missing.
std::optional<double> constant_of(std::span<const double> values) {
  const double first = values.front();
  const bool is_constant = std::all_of(values.begin(), values.end(), [&](double value) { return value == first; });
  return is_constant ? std::optional(first) : std::nullopt;
}

void store_tally(const DesignTally& tally, Writer& writer) {
  for (const std::uint64_t number : {tally.samples, tally.passing, tally.failing, tally.refused}) writer.put(number);
  for (const std::uint64_t number : tally.by_mode) writer.put(number);
  writer.put(tally.worst.value);
  writer.put(tally.worst.index);
}

void load_tally(DesignTally& tally, Reader& reader) {
  for (std::uint64_t* number : {&tally.samples, &tally.passing, &tally.failing, &tally.refused})
    *number = reader.number();
  for (std::uint64_t& number : tally.by_mode) number = reader.number();
  tally.worst.value = reader.real();
  tally.worst.index = reader.number();
}

}  // namespace

void DesignTally::merge(const DesignTally& other) {
  samples += other.samples, passing += other.passing, failing += other.failing, refused += other.refused;
  for (std::size_t i = 0; i < other.by_mode.size(); ++i) by_mode[i] += other.by_mode[i];
  worst.take(other.worst.value, other.worst.index);
}

void Designs::Open::clear() {
  const std::size_t modes = tally.by_mode.size();
  tally = {};
  tally.by_mode.assign(modes, 0);
  utilisation.clear();
  for (sweep::Values& values : results) values.clear();
  met.assign(met.size(), 0);
}

void Designs::Open::merge(const Open& other) {
  tally.merge(other.tally);
  utilisation.merge(other.utilisation);
  for (std::size_t k = 0; k < results.size(); ++k) results[k].merge(other.results[k]);
  for (std::size_t i = 0; i < met.size(); ++i) met[i] += other.met[i];
}

void DemandCounts::merge(const DemandCounts& other) {
  for (std::size_t i = 0; i < of_each.size(); ++i) of_each[i] += other.of_each[i];
  all += other.all;
}

/// Nothing where there are no demands.
void DemandCounts::store(Writer& writer) const {
  for (const std::uint64_t number : of_each) writer.put(number);
  if (!of_each.empty()) writer.put(all);
}

void DemandCounts::load(Reader& reader) {
  for (std::uint64_t& number : of_each) number = reader.number();
  if (!of_each.empty()) all = reader.number();
}

/// Rows that are kept of designs without samples: each block brings some, which costs as much as solving its points.
constexpr std::size_t most_single = 12;

Designs::Designs(DesignsRequest asked)
    : asked_(std::move(asked)),
      pareto_(asked_.aims.empty() ? sweep::Pareto() : sweep::Pareto(asked_.aims)),
      demands_met_(asked_.demands.size()) {
  if (asked_.samples == 1) asked_.most = std::min(asked_.most, most_single);
  scratch_ = none();
}

Designs::Open Designs::none() const {
  Open open;
  open.tally.by_mode.assign(asked_.modes, 0);
  open.results.resize(asked_.results);
  open.met.assign(asked_.demands.size(), 0);
  return open;
}

/// Columns of a block behind the results: state and utilisation of the project, then of each mode.
void Designs::take(const SolvedBlock& block, std::size_t first, std::size_t n, Open& open) const {
  const auto part = [&](std::size_t column) { return std::span(block.results[column]).subspan(first, n); };
  const auto utilisations = part(asked_.results + 1);
  DesignTally& tally = open.tally;
  tally.merge(outcomes_of(part(asked_.results)));
  if (sweep::largest_of(utilisations) > tally.worst.value || std::isnan(tally.worst.value)) {
    for (std::size_t i = 0; i < n; ++i) tally.worst.take(utilisations[i], block.first + first + i);
  }
  for (std::size_t mode = 0; mode < asked_.modes; ++mode)
    tally.by_mode[mode] += count_in(part(asked_.results + 2 + 2 * mode), account::number(State::fail));
  open.utilisation.add(utilisations);
  for (std::size_t k = 0; k < asked_.results; ++k) open.results[k].add(part(k));
  for (std::size_t i = 0; i < open.met.size(); ++i) {
    const SweptDemand& demand = asked_.demands[i];
    for (const double value : part(demand.column)) open.met[i] += demand.is_met(value) ? 1U : 0U;
  }
}

void Designs::add(const SolvedBlock& block) {
  if (asked_.samples == 0) return;
  if (asked_.samples == 1) return add_single(block);
  for (std::size_t first = 0; first < block.count;) {
    const std::uint64_t point = block.first + first, design = point / asked_.samples;
    const std::uint64_t end = std::min((design + 1) * asked_.samples, block.first + block.count);
    const auto n = static_cast<std::size_t>(end - point);
    add_part(block, design, first, n);
    first += n;
  }
}

/// The points of a block that belong to one design. Of a complete one that is not among the first, only the outcomes
/// are counted.
void Designs::add_part(const SolvedBlock& block, std::uint64_t design, std::size_t first, std::size_t n) {
  if (n == asked_.samples) {
    const auto part = [&](std::size_t column) { return std::span(block.results[column]).subspan(first, n); };
    const DesignTally tally = outcomes_of(part(asked_.results));
    const auto value = asked_.results == 0 ? std::optional<double>(NAN) : constant_of(part(0));
    const bool is_known = value && asked_.aims.empty();
    if (is_known && !is_among_the_first(key_of(design, tally, *value))) return count(tally);
    scratch_.clear();
    take(block, first, n, scratch_);
    return close(design, scratch_);
  }
  Open& open = open_.try_emplace(design, none()).first->second;
  take(block, first, n, open);
  if (open.tally.samples != asked_.samples) return;
  close(design, open);
  open_.erase(design);
}

/// Every point is a design: only the first ones of a block can be among the first of all.
void Designs::add_single(const SolvedBlock& block) {
  const std::vector<double>& states = block.results[asked_.results];
  const Key last =
      rows_.size() < asked_.most ? Key{INFINITY, INFINITY, INFINITY, INFINITY} : std::prev(rows_.end())->first;
  candidates_.clear();
  for (std::size_t i = 0; i < block.count; ++i) {
    const double state = states[i];
    if (state == account::refused_state) continue;
    const double failing = state == account::number(State::fail) ? 1.0 : 0.0;
    if (failing > last[0]) continue;
    const double first = asked_.results == 0 ? INFINITY : block.results[0][i];
    const Key key{failing, failing > 0.0 || passes(state) ? 0.0 : 1.0, std::isnan(first) ? INFINITY : first,
                  static_cast<double>(block.first + i)};
    if (key < last) candidates_.push_back(key);
  }
  const auto kept = std::min(candidates_.size(), asked_.most);
  const auto end = candidates_.begin() + static_cast<std::ptrdiff_t>(kept);
  std::partial_sort(candidates_.begin(), end, candidates_.end());
  for (auto key = candidates_.begin(); key != end; ++key) {
    const auto design = static_cast<std::uint64_t>((*key)[3]);
    const auto i = static_cast<std::size_t>(design - block.first);
    scratch_.clear();
    take(block, i, 1, scratch_);
    const double used = block.results[asked_.results + 1][i];
    DesignRow row{design, scratch_.tally, used, used, {}};
    for (std::size_t k = 0; k < asked_.results; ++k) row.results.push_back(block.results[k][i]);
    keep(*key, std::move(row));
  }
}

void Designs::count(const DesignTally& tally) {
  if (tally.refused == tally.samples)
    ++counts_.invalid;
  else if (tally.failing == tally.samples)
    ++counts_.all_fail;
  else if (tally.failing > 0)
    ++counts_.some_fail;
  else
    ++(tally.open() > 0 ? counts_.not_assessed : counts_.all_pass);
}

void Designs::close(std::uint64_t design, const Open& open) {
  const DesignTally& tally = open.tally;
  count(tally);
  if (tally.refused == tally.samples) return;
  const Key key = key_of(design, tally, open.results.empty() ? NAN : open.results.front().quantile(level_of(0)));
  const bool is_kept = is_among_the_first(key);
  if (!is_kept && asked_.aims.empty()) return;
  DesignRow row{design, tally, open.utilisation.quantile(0.5), open.utilisation.quantile(asked_.quantile), {}};
  for (std::size_t k = 0; k < asked_.results; ++k) row.results.push_back(open.results[k].quantile(level_of(k)));
  if (!asked_.aims.empty() && satisfies_demands(open)) add_to_front(row);
  if (is_kept) keep(key, std::move(row));
}

/// Whether a design satisfies all demands, which is counted.
bool Designs::satisfies_demands(const Open& open) {
  bool all = true;
  for (std::size_t i = 0; i < asked_.demands.size(); ++i) {
    const SweptDemand& demand = asked_.demands[i];
    const sweep::Values& values = open.results[demand.column];
    const bool is_met = demand.is_met(open.met[i], values.count(), open.tally.samples, values.quantile(asked_.quantile),
                                      asked_.quantile);
    demands_met_.of_each[i] += is_met ? 1U : 0U;
    all = all && is_met;
  }
  demands_met_.all += all ? 1U : 0U;
  return all;
}

void Designs::add_to_front(const DesignRow& row) {
  std::vector<const double*> objectives;
  for (const std::size_t column : asked_.columns) objectives.push_back(&row.results[column]);
  pareto_.add(row.design, objectives, 1, [&](std::size_t) { return row.results; });
}

Designs::Key Designs::key_of(std::uint64_t design, const DesignTally& tally, double first) const {
  const auto share = [&](std::uint64_t n) { return static_cast<double>(n) / static_cast<double>(tally.samples); };
  return {share(tally.failing), share(tally.open()), std::isnan(first) ? INFINITY : first, static_cast<double>(design)};
}

bool Designs::is_among_the_first(const Key& key) const {
  return rows_.size() < asked_.most || (!rows_.empty() && key < std::prev(rows_.end())->first);
}

double Designs::level_of(std::size_t result) const {
  const auto objective = std::find(asked_.columns.begin(), asked_.columns.end(), result);
  if (objective == asked_.columns.end()) return 0.5;
  const sweep::Aim aim = asked_.aims[static_cast<std::size_t>(objective - asked_.columns.begin())];
  return aim == sweep::Aim::min ? asked_.quantile : 1.0 - asked_.quantile;
}

void Designs::keep(const Key& key, DesignRow row) {
  rows_.emplace(key, std::move(row));
  if (rows_.size() > asked_.most) rows_.erase(std::prev(rows_.end()));
}

void Designs::merge(const Designs& other) {
  counts_.all_pass += other.counts_.all_pass, counts_.some_fail += other.counts_.some_fail;
  counts_.all_fail += other.counts_.all_fail, counts_.not_assessed += other.counts_.not_assessed;
  counts_.invalid += other.counts_.invalid;
  for (const auto& [key, row] : other.rows_) keep(key, row);
  pareto_.merge(other.pareto_);
  demands_met_.merge(other.demands_met_);
  for (const auto& [design, theirs] : other.open_) {
    Open& open = open_.try_emplace(design, none()).first->second;
    open.merge(theirs);
    if (open.tally.samples != asked_.samples) continue;
    close(design, open);
    open_.erase(design);
  }
}

std::vector<DesignRow> Designs::rows() const {
  std::vector<DesignRow> all;
  all.reserve(rows_.size());
  for (const auto& [key, row] : rows_) all.push_back(row);
  return all;
}

void Designs::store(Writer& writer) const {
  for (const std::uint64_t number :
       {counts_.all_pass, counts_.some_fail, counts_.all_fail, counts_.not_assessed, counts_.invalid})
    writer.put(number);
  writer.put(std::uint64_t{rows_.size()});
  for (const auto& [key, row] : rows_) {
    for (const double part : key) writer.put(part);
    store_tally(row.tally, writer);
    writer.put(row.median);
    writer.put(row.quantile);
    for (const double value : row.results) writer.put(value);
  }
  writer.put(std::uint64_t{open_.size()});
  for (const auto& [design, open] : open_) {
    writer.put(design);
    store_tally(open.tally, writer);
    open.utilisation.store(writer);
    for (const sweep::Values& values : open.results) values.store(writer);
    for (const std::uint64_t number : open.met) writer.put(number);
  }
  pareto_.store(writer);
  demands_met_.store(writer);
}

void Designs::load(Reader& reader) {
  for (std::uint64_t* number :
       {&counts_.all_pass, &counts_.some_fail, &counts_.all_fail, &counts_.not_assessed, &counts_.invalid})
    *number = reader.number();
  rows_.clear();
  for (std::uint64_t left = reader.count(12); left > 0 && !reader.failed(); --left) {
    Key key{};
    for (double& part : key) part = reader.real();
    DesignRow row{static_cast<std::uint64_t>(key[3]), none().tally, 0.0, 0.0, {}};
    load_tally(row.tally, reader);
    row.median = reader.real();
    row.quantile = reader.real();
    row.results.resize(asked_.results);
    for (double& value : row.results) value = reader.real();
    rows_.emplace(key, std::move(row));
  }
  open_.clear();
  for (std::uint64_t left = reader.count(8); left > 0 && !reader.failed(); --left) {
    const std::uint64_t design = reader.number();
    Open& open = open_.try_emplace(design, none()).first->second;
    load_tally(open.tally, reader);
    open.utilisation.load(reader);
    for (sweep::Values& values : open.results) values.load(reader);
    for (std::uint64_t& number : open.met) number = reader.number();
  }
  pareto_.load(reader);
  demands_met_.load(reader);
}

}  // namespace loadpath::project
