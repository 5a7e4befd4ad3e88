#include "lib/sweep/nan.hpp"
#include "lib/sweep/statistics/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::sweep {

namespace {

/// The linear interpolation from a to b at share t, never beyond.
double between(double a, double b, double t) { return std::clamp(a + (b - a) * t, a, b); }

}  // namespace

Ranks::Ranks(const Sketch& sketch) : classes_(sketch.classes()) {
  for (const ValueClass& of : classes_) {
    before_.push_back(count_);
    count_ += of.count;
  }
}

double Ranks::at(std::uint64_t rank) const {
  if (rank >= count_) return nan;
  const auto k = static_cast<std::size_t>(std::upper_bound(before_.begin(), before_.end(), rank) - before_.begin()) - 1;
  const ValueClass& of = classes_[k];
  if (of.count == 1) return of.least;
  return between(of.least, of.largest, static_cast<double>(rank - before_[k]) / static_cast<double>(of.count - 1));
}

double Ranks::quantile(double p) const {
  if (count_ == 0 || !(p >= 0.0 && p <= 1.0)) return nan;
  const double place = p * static_cast<double>(count_ - 1), whole = std::floor(place);
  const auto rank = static_cast<std::uint64_t>(whole);
  const double low = at(rank), part = place - whole;
  return part > 0.0 ? between(low, at(std::min(rank + 1, count_ - 1)), part) : low;
}

Interval Ranks::quantile_bounds(double p, double confidence) const {
  if (count_ == 0 || !(p > 0.0 && p < 1.0 && confidence > 0.0 && confidence < 1.0)) return {nan, nan};
  const auto [low, high] = rank_bounds(count_, p, confidence);
  return {low > 0 ? at(low - 1) : nan, high <= count_ ? at(high - 1) : nan};
}

std::uint64_t Ranks::below(double x) const {
  const auto reaching =
      std::partition_point(classes_.begin(), classes_.end(), [&](const ValueClass& of) { return of.largest < x; });
  if (reaching == classes_.end()) return count_;
  const std::uint64_t before = before_[static_cast<std::size_t>(reaching - classes_.begin())];
  if (!(x > reaching->least)) return before;
  // The largest is at x or beyond: among the others the share below x is that of a uniform distribution.
  const double share = (x - reaching->least) / (reaching->largest - reaching->least);
  const double some = std::ceil(share * static_cast<double>(reaching->count - 1));
  return before + std::clamp<std::uint64_t>(static_cast<std::uint64_t>(some), 1, reaching->count - 1);
}

Histogram Ranks::counted(std::vector<double> edges) const {
  Histogram found{std::move(edges), {}};
  std::uint64_t before = 0;
  for (std::size_t k = 1; k < found.edges.size(); ++k) {
    const std::uint64_t until = k + 1 < found.edges.size() ? below(found.edges[k]) : count_;
    found.counts.push_back(until - before);
    before = until;
  }
  return found;
}

Histogram Ranks::histogram(std::size_t bins) const {
  if (count_ == 0 || bins == 0) return {};
  const double low = classes_.front().least, high = classes_.back().largest;
  std::vector<double> edges;
  for (std::size_t k = 0; k <= bins; ++k)
    edges.push_back(between(low, high, static_cast<double>(k) / static_cast<double>(bins)));
  edges.back() = high;
  return counted(std::move(edges));
}

Histogram Ranks::logarithmic_histogram(std::size_t bins) const {
  if (count_ == 0 || bins == 0 || !(classes_.front().least > 0.0)) return {};
  const double low = classes_.front().least, high = classes_.back().largest, decades = std::log(high / low);
  std::vector<double> edges;
  for (std::size_t k = 0; k <= bins; ++k) {
    const double edge = low * std::exp(decades * static_cast<double>(k) / static_cast<double>(bins));
    edges.push_back(std::clamp(edge, low, high));
  }
  edges.back() = high;
  return counted(std::move(edges));
}

}  // namespace loadpath::sweep
