#include "lib/sweep/statistics/moments.hpp"

#include "lib/simd/attributes.hpp"
#include "lib/sweep/nan.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::sweep {

namespace {

struct Powers {
  double square, cube, fourth;
};

LOADPATH_COLUMNS Powers powers_about(double mean, const double* x, std::size_t n) {
  Lanes square{}, cube{}, fourth{};
  in_lanes(n, [&](std::size_t i, std::size_t lane) {
    const double d = is_finite(x[i]) ? x[i] - mean : 0.0, d2 = d * d;
    square[lane] += d2;
    cube[lane] += d2 * d;
    fourth[lane] += d2 * d2;
  });
  return {sum_of(square), sum_of(cube), sum_of(fourth)};
}

struct Distances {
  double count, sum;
};

LOADPATH_COLUMNS Distances distances_from(double from, const double* x, std::size_t n) {
  Lanes count{}, sum{};
  in_lanes(n, [&](std::size_t i, std::size_t lane) {
    count[lane] += is_finite(x[i]) ? 1.0 : 0.0;
    sum[lane] += is_finite(x[i]) ? x[i] - from : 0.0;
  });
  return {sum_of(count), sum_of(sum)};
}

}  // namespace

Moments::Moments(std::span<const double> values) {
  const auto first = std::find_if(values.begin(), values.end(), is_finite);
  if (first == values.end()) return;
  const auto [count, sum] = distances_from(*first, values.data(), values.size());
  *this = Moments(values, static_cast<std::uint64_t>(count), *first, sum);
}

Moments::Moments(std::span<const double> values, std::uint64_t count, double from, double sum) : count_(count) {
  if (count == 0) return;
  mean_ = from + sum / static_cast<double>(count);
  const Powers found = powers_about(mean_, values.data(), values.size());
  square_ = found.square;
  cube_ = found.cube;
  fourth_ = found.fourth;
}

void Moments::merge(const Moments& right) {
  if (right.count_ == 0) return;
  if (count_ == 0) {
    *this = right;
    return;
  }
  const auto a = static_cast<double>(count_), b = static_cast<double>(right.count_);
  const double n = a + b, d = right.mean_ - mean_, step = d / n, step2 = step * step;
  fourth_ += right.fourth_ + d * step * step2 * a * b * (a * a - a * b + b * b) +
             6.0 * step2 * (a * a * right.square_ + b * b * square_) + 4.0 * step * (a * right.cube_ - b * cube_);
  cube_ += right.cube_ + d * step2 * a * b * (a - b) + 3.0 * step * (a * right.square_ - b * square_);
  square_ += right.square_ + d * step * a * b;
  mean_ += step * b;
  count_ += right.count_;
}

double Moments::mean() const { return count_ > 0 ? mean_ : nan; }
double Moments::variance() const { return count_ > 1 ? square_ / static_cast<double>(count_ - 1) : nan; }
double Moments::sd() const { return std::sqrt(variance()); }
double Moments::error() const { return std::sqrt(variance() / static_cast<double>(count_)); }

double Moments::skewness() const {
  return square_ > 0.0 ? std::sqrt(static_cast<double>(count_)) * cube_ / (square_ * std::sqrt(square_)) : nan;
}

double Moments::kurtosis() const {
  return square_ > 0.0 ? static_cast<double>(count_) * fourth_ / (square_ * square_) - 3.0 : nan;
}

void Moments::store(Writer& writer) const {
  writer.put(count_);
  for (const double sum : {mean_, square_, cube_, fourth_}) writer.put(sum);
}

void Moments::load(Reader& reader) {
  count_ = reader.number();
  for (double* const sum : {&mean_, &square_, &cube_, &fourth_}) *sum = reader.real();
}

}  // namespace loadpath::sweep
