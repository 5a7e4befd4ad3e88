#include "lib/sweep/statistics/summary.hpp"

#include "lib/simd/attributes.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace loadpath::sweep {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct PartialSums {
  double count, sum, min, max;
};

/// Over the finite values: how many, the sum of their distances from one of them, and the ends.
LOADPATH_COLUMNS PartialSums partial_sums(double from, const double* x, std::size_t n) {
  Lanes count{}, sum{}, min, max;
  min.fill(infinity);
  max.fill(-infinity);
  in_lanes(n, [&](std::size_t i, std::size_t lane) {
    const bool there = is_finite(x[i]);
    const double low = there ? x[i] : infinity, high = there ? x[i] : -infinity;
    count[lane] += there ? 1.0 : 0.0;
    sum[lane] += there ? x[i] - from : 0.0;
    min[lane] = low < min[lane] ? low : min[lane];
    max[lane] = high > max[lane] ? high : max[lane];
  });
  return {sum_of(count), sum_of(sum), *std::min_element(min.begin(), min.end()),
          *std::max_element(max.begin(), max.end())};
}

/// Takes the other if it is beyond, or the same and earlier.
template <class Beyond>
void take(Extreme& own, const Extreme& other, const Beyond& beyond) {
  if (std::isnan(other.value)) return;
  if (std::isnan(own.value) || beyond(other.value, own.value))
    own = other;
  else if (other.value == own.value)
    own.index = std::min(own.index, other.index);
}

Extreme place_of(double value, std::uint64_t first, std::span<const double> values) {
  return {value, first + static_cast<std::uint64_t>(std::find(values.begin(), values.end(), value) - values.begin())};
}

void store_extreme(Writer& writer, const Extreme& of) {
  writer.put(of.value);
  writer.put(of.index);
}

Extreme load_extreme(Reader& reader) {
  const double value = reader.real();
  return {value, reader.number()};
}

}  // namespace

bool Summary::add(std::uint64_t block, std::uint64_t first, std::span<const double> values) {
  const auto begin = std::find_if(values.begin(), values.end(), is_finite);
  const double from = begin == values.end() ? 0.0 : *begin;
  const PartialSums seen = partial_sums(from, values.data(), values.size());
  const auto count = static_cast<std::uint64_t>(seen.count);
  if (!moments_.add(block, Moments(values, count, from, seen.sum))) return false;
  count_ += count;
  missing_ += values.size() - count;
  if (count == 0) return true;
  // Looked for only where it is not beaten already; the comparisons hold if there is none yet.
  if (!(seen.min > min_.value)) take(min_, place_of(seen.min, first, values), std::less<>{});
  if (!(seen.max < max_.value)) take(max_, place_of(seen.max, first, values), std::greater<>{});
  sketch_.add(values);
  return true;
}

bool Summary::merge(const Summary& other) {
  if (!moments_.merge(other.moments_)) return false;
  count_ += other.count_;
  missing_ += other.missing_;
  take(min_, other.min_, std::less<>{});
  take(max_, other.max_, std::greater<>{});
  sketch_.merge(other.sketch_);
  return true;
}

void Summary::store(Writer& writer) const {
  writer.put(count_);
  writer.put(missing_);
  store_extreme(writer, min_);
  store_extreme(writer, max_);
  moments_.store(writer);
  sketch_.store(writer);
}

void Summary::load(Reader& reader) {
  count_ = reader.number();
  missing_ = reader.number();
  min_ = load_extreme(reader);
  max_ = load_extreme(reader);
  moments_.load(reader);
  sketch_.load(reader);
}

}  // namespace loadpath::sweep
