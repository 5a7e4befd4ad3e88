#include "lib/sweep/sensitivity/robust.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace loadpath::sweep {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (static_cast<double>(values.size()) - 1.0));
}

double quantile_of(std::vector<double>& values, double p) {
  const double rank = p * static_cast<double>(values.size() - 1), below = std::floor(rank);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  if (rank == below) return *at;
  return *at + (rank - below) * (*std::min_element(at + 1, values.end()) - *at);
}

template <class Passes>
double failing_share(std::span<const double> values, const Passes& passes) {
  return static_cast<double>(std::count_if(values.begin(), values.end(), [&](double v) { return !passes(v); })) /
         static_cast<double>(values.size());
}

}  // namespace

Robust::Robust(Function& inner, std::size_t designs, std::vector<Scattered> inputs, std::size_t columns,
               Sampler sampler, std::size_t samples, std::vector<Statistic> statistics, FirstSample first)
    : inner_(inner),
      designs_(designs),
      samples_(samples),
      from_(std::move(inputs)),
      statistics_(std::move(statistics)),
      sampler_(std::move(sampler)),
      first_(std::move(first)),
      scatter_(columns, samples),
      in_(inner.inputs(), samples),
      out_(inner.outputs(), samples) {
  assert(samples >= 2);
  sampler_(drawn_, samples, scatter_.write());
}

/// The samples of design k.
void Robust::draw(std::span<const double* const> in, std::size_t k) {
  if (!first_) return;
  std::vector<double> design;
  design.reserve(in.size());
  for (const double* const column : in) design.push_back(column[k]);
  const std::uint64_t first = first_(design);
  if (first != drawn_) sampler_(first, samples_, scatter_.write());
  drawn_ = first;
}

double Robust::value_of(const Statistic& statistic) {
  using Kind = Statistic::Kind;
  const std::span<const double> values(out_[statistic.output], samples_);
  if (statistic.kind == Kind::above_one)
    return failing_share(values, [](double u) { return std::isfinite(u) && u <= 1.0; }) / statistic.p;
  if (statistic.kind == Kind::not_one)
    return failing_share(values, [](double flag) { return flag == 1.0; }) / statistic.p;
  if (!all_finite(values)) return none;
  if (statistic.kind == Kind::mean) return mean_of(values);
  if (statistic.kind == Kind::deviation) return deviation_of(values);
  sorted_.assign(values.begin(), values.end());
  return quantile_of(sorted_, statistic.p);
}

void Robust::evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    draw(in, k);
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const auto& [design, scatter, relative] = from_[i];
      const double x = design ? in[*design][k] : 0.0;
      for (std::size_t s = 0; s < samples_; ++s) {
        const double by = scatter ? scatter_[*scatter][s] : 0.0;
        in_[i][s] = relative ? x * (1.0 + by) : x + by;
      }
    }
    inner_.evaluate(in_.read(), out_.write(), samples_);
    for (std::size_t o = 0; o < statistics_.size(); ++o) out[o][k] = value_of(statistics_[o]);
  }
}

}  // namespace loadpath::sweep
