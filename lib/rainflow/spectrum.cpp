#include "lib/rainflow/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace loadpath::rainflow {

Outcome<Classes> Classes::make(double low, double width, std::size_t count) {
  Classes classes;
  classes.low_ = low, classes.width_ = width, classes.count_ = count;
  if (count == 0 || count > most) return Fault{0, 1, say("there must be 1 to 1024 classes"), {}};
  const bool wide_enough = width > 0.0 && std::isfinite(low) && std::isfinite(classes.bound(count)) &&
                           classes.bound(1) > low && classes.bound(count) > classes.bound(count - 1);
  if (!wide_enough) return Fault{0, 1, say("the width of a class must be above 0"), {}};
  return classes;
}

std::optional<std::size_t> Classes::of(double x) const {
  if (count_ == 0 || !(x >= low_ && x <= bound(count_))) return std::nullopt;
  auto i = std::min(static_cast<std::size_t>((x - low_) / width_), count_ - 1);
  // The quotient is rounded; the bounds are exact.
  if (x < bound(i)) --i;
  if (i + 1 < count_ && x >= bound(i + 1)) ++i;
  return i;
}

RainflowMatrix::RainflowMatrix(Classes classes) : classes_(classes), counts_(classes.count() * classes.count(), 0.0) {}

void RainflowMatrix::take(const Batch& batch) {
  for (const Loop& loop : batch.loops) {
    const auto from = classes_.of(loop.from), to = classes_.of(loop.to);
    (from && to ? counts_[*from * classes_.count() + *to] : outside_) += batch.count;
  }
}

void RangePairs::take(const Batch& batch) {
  for (const Loop& loop : batch.loops) {
    const auto i = classes_.of(loop.range());
    (i ? counts_[*i] : outside_) += batch.count;
  }
}

std::vector<double> RangePairs::exceedances() const {
  std::vector<double> sums(counts_.size());
  std::partial_sum(counts_.rbegin(), counts_.rend(), sums.rbegin());
  return sums;
}

std::vector<Level> RangePairs::levels(Measure measure) const {
  std::vector<Level> levels;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const double range = classes_.bound(i + 1);
    if (counts_[i] > 0.0) levels.push_back({measure == Measure::amplitude ? range / 2.0 : range, counts_[i]});
  }
  return levels;
}

LevelCrossings::LevelCrossings(std::vector<double> levels)
    : levels_(std::move(levels)), up_(levels_.size() + 1, 0), down_(levels_.size() + 1, 0) {
  std::erase_if(levels_, [](double level) { return !std::isfinite(level); });
  std::sort(levels_.begin(), levels_.end());
}

std::size_t LevelCrossings::below(double x) const {
  return static_cast<std::size_t>(std::upper_bound(levels_.begin(), levels_.end(), x) - levels_.begin());
}

void LevelCrossings::pass(std::span<const double> turning_points) {
  for (const double x : turning_points) {
    const std::size_t now = below(x), before = last_.value_or(now);
    auto& counts = now > before ? up_ : down_;
    ++counts[std::min(now, before)];
    --counts[std::max(now, before)];
    last_ = now;
  }
}

std::vector<LevelCrossings::Crossing> LevelCrossings::crossings() const {
  std::vector<Crossing> found;
  std::int64_t up = 0, down = 0;
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    up += up_[i], down += down_[i];
    found.push_back({levels_[i], static_cast<std::uint64_t>(up), static_cast<std::uint64_t>(down)});
  }
  return found;
}

}  // namespace loadpath::rainflow
