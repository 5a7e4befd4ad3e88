// Counting by an independent method: all of the series in memory, and the smallest range that closes is taken out
// repeatedly.
#pragma once

#include "lib/rainflow/counter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace loadpath::rainflow::testing {

using Series = std::vector<double>;
/// The count of each cycle, by range and mean.
using Counts = std::map<std::pair<double, double>, double>;

inline Series naive_turning_points(Series series) {
  series.erase(std::unique(series.begin(), series.end()), series.end());
  Series found;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const bool inside = i > 0 && i + 1 < series.size();
    if (!inside || (series[i] - series[i - 1] > 0) != (series[i + 1] - series[i] > 0)) found.push_back(series[i]);
  }
  return found;
}

inline void note(Counts& counts, double a, double b, double count) {
  counts[{std::abs(b - a), a / 2.0 + b / 2.0}] += count;
}

/// The closed cycles of a history, as full ones; the remaining turning points.
inline Series naive_closed(const Series& series, Counts& counts) {
  Series points = naive_turning_points(series);
  for (;;) {
    std::size_t smallest = 0;
    const auto range = [&](std::size_t i) { return std::abs(points[i + 1] - points[i]); };
    for (std::size_t i = 1; i + 2 < points.size(); ++i) {
      const bool closes = range(i) <= range(i - 1) && range(i) <= range(i + 1);
      if (closes && (smallest == 0 || range(i) < range(smallest))) smallest = i;
    }
    if (smallest == 0) return points;
    note(counts, points[smallest], points[smallest + 1], 1.0);
    const auto at = points.begin() + static_cast<std::ptrdiff_t>(smallest);
    points.erase(at, at + 2);
  }
}

inline Counts naive_with_halves(const Series& series) {
  Counts counts;
  const Series left = naive_closed(series, counts);
  for (std::size_t i = 0; i + 1 < left.size(); ++i) note(counts, left[i], left[i + 1], 0.5);
  return counts;
}

/// A repeating history: the difference of three periods and two.
inline Counts naive_periodic(const Series& period) {
  const auto closed = [&](int periods) {
    Series series;
    for (int i = 0; i < periods; ++i) series.insert(series.end(), period.begin(), period.end());
    Counts counts;
    naive_closed(series, counts);
    return counts;
  };
  Counts more = closed(4);
  for (const auto& [cycle, count] : closed(3)) more[cycle] -= count;
  std::erase_if(more, [](const auto& cycle) { return cycle.second == 0.0; });
  return more;
}

/// Keeps cycles as counts.
class Tally : public Consumer {
 public:
  void take(const Batch& batch) override {
    for (const Loop& loop : batch.loops) counts[{loop.range(), loop.mean()}] += batch.count;
  }
  Counts counts;
};

inline Counts counted(std::span<const double> series, const Rules& rules = {}) {
  Tally tally;
  Counter counter(rules, tally);
  REQUIRE(!counter.feed(series));
  counter.finish();
  return tally.counts;
}

inline Counts counted_periodic(std::span<const double> period, const Rules& rules = {}) {
  Tally tally;
  REQUIRE(!count_periodic(period, rules, tally));
  return tally.counts;
}

/// Values between -100 and 100; of few different ones where `steps` is not 0, so that ranges are equal and plateaus
/// there.
inline Series noise(std::size_t count, unsigned seed, int steps = 0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(-100.0, 100.0);
  Series series(count);
  for (double& x : series) {
    x = between(random);
    if (steps > 0) x = std::round(x / 100.0 * steps);
  }
  return series;
}

/// A sum of sines that no two periods of agree in, with a few samples for each turn.
inline Series waves(std::size_t count, double speed = 0.7) {
  Series series(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = speed * static_cast<double>(i);
    series[i] = 80.0 * std::sin(0.013 * t) + 40.0 * std::sin(0.41 * t) + 25.0 * std::sin(1.17 * t + 1.0);
  }
  return series;
}

}  // namespace loadpath::rainflow::testing
