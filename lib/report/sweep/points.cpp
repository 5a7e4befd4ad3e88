#include "lib/report/sweep/points.hpp"

#include "lib/project/sweep/ranges.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::report {

namespace {

using project::BlockRange;
using project::SweepPlan;
using project::SweepStatistics;
using project::SweptInput;

constexpr std::size_t most = 2000;       // dots of a figure
constexpr std::size_t most_front = 800;  // limit of their number
constexpr std::size_t most_worst = 100;

SolvedPoints solved(const SweepPlan& plan, const project::ReadAgain& read, std::vector<std::uint64_t> numbers) {
  std::vector<std::string> texts;
  for (const project::SweptResult& column : plan.columns) texts.push_back(column.name + " = " + column.text);
  project::Variants variants(read(), texts);
  SolvedPoints points{std::move(numbers), {}, {}};
  const std::size_t n = points.size();
  points.inputs.assign(variants.inputs(), std::vector<double>(n));
  points.results.assign(variants.outputs(), std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double> values = plan.at(points.numbers[i]);
    for (std::size_t k = 0; k < values.size(); ++k) points.inputs[k][i] = values[k];
  }
  std::vector<const double*> in;
  std::vector<double*> out;
  for (const auto& column : points.inputs) in.push_back(column.data());
  for (auto& column : points.results) out.push_back(column.data());
  if (n > 0) variants.evaluate(in, out, n);
  return points;
}

/// About `wanted` of `count` places, the ends among them.
std::vector<std::uint64_t> spread_out(std::uint64_t count, std::size_t wanted) {
  std::vector<std::uint64_t> places;
  if (count <= wanted) {
    for (std::uint64_t i = 0; i < count; ++i) places.push_back(i);
    return places;
  }
  for (std::size_t k = 0; k < wanted; ++k)
    places.push_back(static_cast<std::uint64_t>(
        std::llround(static_cast<double>(k) * static_cast<double>(count - 1) / static_cast<double>(wanted - 1))));
  return places;
}

/// Steps by the golden section meet every part of the points alike, and none of their digits.
void add_evenly(std::uint64_t first, std::uint64_t last, std::set<std::uint64_t>& numbers) {
  constexpr double golden = 0.6180339887498949;
  const std::uint64_t count = last - first;
  if (count + numbers.size() <= most) {
    for (std::uint64_t i = first; i < last; ++i) numbers.insert(i);
    return;
  }
  for (std::size_t k = 0; numbers.size() < most && k < 2 * most; ++k) {
    double whole = 0.0;
    const double share = std::modf(static_cast<double>(k) * golden, &whole);
    numbers.insert(first + std::min(count - 1, static_cast<std::uint64_t>(share * static_cast<double>(count))));
  }
}

std::vector<std::uint64_t> numbers_of_cloud(const SweepPlan& plan, const SweepStatistics& found,
                                            const BlockRange& blocks) {
  std::set<std::uint64_t> numbers;
  const auto front = found.pareto();
  for (const std::uint64_t i : spread_out(front.size(), most_front)) numbers.insert(front[i].index);
  const auto worst = found.worst();
  for (std::size_t i = 0; i < std::min(worst.size(), most_worst); ++i) numbers.insert(worst[i].index);
  add_evenly(blocks.first * project::block_size, std::min(blocks.last * project::block_size, plan.space.count()),
             numbers);
  return {numbers.begin(), numbers.end()};
}

/// Places of an axis in rising order of their values; none if two values are equal.
std::vector<std::uint64_t> rising_places(const SweptInput& input, std::size_t wanted) {
  std::vector<std::uint64_t> places = spread_out(input.axis.size(), wanted);
  const auto value = [&](std::uint64_t i) { return input.axis.at(i); };
  std::sort(places.begin(), places.end(), [&](auto a, auto b) { return value(a) < value(b); });
  const auto equal = [&](auto a, auto b) { return value(a) == value(b); };
  return std::adjacent_find(places.begin(), places.end(), equal) == places.end() ? places
                                                                                 : std::vector<std::uint64_t>{};
}

/// The number of columns and rows that fit.
std::pair<std::size_t, std::size_t> size_of_plane(std::uint64_t across, std::uint64_t up) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(most)));
  const auto fitting = [&](std::uint64_t values, std::uint64_t other) {
    const std::size_t room = std::max(side, most / static_cast<std::size_t>(std::min<std::uint64_t>(other, most)));
    return static_cast<std::size_t>(std::min<std::uint64_t>(values, room));
  };
  return {fitting(across, up), fitting(up, across)};
}

bool has_axis(const SweptInput& input) { return !input.distribution && input.words.empty() && input.axis.size() > 1; }

/// The plane of two inputs whose values make up all points; of two inputs zipped together the first represents both.
std::optional<Plane> plane_of(const SweepPlan& plan, std::size_t a, std::size_t b) {
  const SweptInput &first = plan.inputs[a], &second = plan.inputs[b];
  const std::uint64_t rows = second.axis.size();
  if (!has_axis(first) || !has_axis(second) || first.axis.size() * rows != plan.space.count()) return std::nullopt;
  const auto [wide, high] = size_of_plane(first.axis.size(), rows);
  const auto across = rising_places(first, wide), up = rising_places(second, high);
  Plane plane{a, b, across.size(), {}};
  for (const std::uint64_t j : up) {
    for (const std::uint64_t i : across) {
      const std::uint64_t number = i * rows + j;
      const std::vector<double> values = plan.at(number);
      if (values[a] != first.axis.at(i) || values[b] != second.axis.at(j)) return std::nullopt;
      plane.points.numbers.push_back(number);
    }
  }
  return across.size() < 2 || up.size() < 2 ? std::nullopt : std::optional(std::move(plane));
}

std::optional<Plane> plane_of(const SweepPlan& plan) {
  for (std::size_t a = 0; a < plan.inputs.size(); ++a) {
    for (std::size_t b = a + 1; b < plan.inputs.size(); ++b) {
      if (auto plane = plane_of(plan, a, b)) return plane;
    }
  }
  return std::nullopt;
}

/// The designs as points of a figure: results as in their rows, as verdict that of the quantile.
SolvedPoints points_of_designs(const SweepPlan& plan, const SweepStatistics& found) {
  std::vector<project::DesignRow> rows = found.designs().rows();
  std::sort(rows.begin(), rows.end(),
            [](const project::DesignRow& a, const project::DesignRow& b) { return a.design < b.design; });
  const double allowed = 1.0 - found.designs().asked().quantile;
  SolvedPoints points;
  points.inputs.resize(plan.inputs.size());
  points.results.resize(plan.columns.size() + 2);
  for (const project::DesignRow& row : rows) {
    points.numbers.push_back(row.design * found.designs().asked().samples);
    const std::vector<double> values = plan.at(row.design * found.designs().asked().samples);
    for (std::size_t i = 0; i < plan.inputs.size(); ++i)
      points.inputs[i].push_back(plan.inputs[i].distribution ? project::middle_of(plan.inputs[i]) : values[i]);
    for (std::size_t k = 0; k < plan.columns.size(); ++k) points.results[k].push_back(row.results[k]);
    const auto samples = static_cast<double>(row.tally.samples);
    const bool fails = static_cast<double>(row.tally.failing) > allowed * samples;
    const bool open = static_cast<double>(row.tally.open()) > allowed * samples;
    using account::State;
    points.results[plan.columns.size()].push_back(account::number(fails  ? State::fail
                                                                  : open ? State::not_judged
                                                                         : State::pass));
    points.results[plan.columns.size() + 1].push_back(row.quantile);
  }
  return points;
}

}  // namespace

DrawnPoints points_to_draw(const SweepPlan& plan, const SweepStatistics& found, const BlockRange& blocks,
                           const project::ReadAgain& read) {
  DrawnPoints drawn;
  if (found.keep().objectives.size() >= 2)
    drawn.cloud = project::has_scattering_designs(plan) ? points_of_designs(plan, found)
                                                        : solved(plan, read, numbers_of_cloud(plan, found, blocks));
  const bool whole = blocks.count() == project::all_blocks(plan).count();
  if (whole) drawn.plane = plane_of(plan);
  if (drawn.plane) drawn.plane->points = solved(plan, read, std::move(drawn.plane->points.numbers));
  return drawn;
}

}  // namespace loadpath::report
