#include "lib/sweep/sensitivity/sobol.hpp"

#include "lib/sweep/column_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::sweep {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double two_sided_95 = 1.959963984540054;  // the normal quantile of 0.975

/// The rows A and B of a block, and those at which the function is evaluated.
class Rows {
 public:
  Rows(const Sampler& sampler, std::size_t inputs, std::uint64_t first, std::size_t n)
      : count(n), drawn(inputs, 2 * n), a(inputs, n), b(inputs, n), starts(inputs) {
    sampler(2 * first, 2 * n, drawn.write());
    for (std::size_t i = 0; i < inputs; ++i) {
      for (std::size_t k = 0; k < n; ++k) a[i][k] = drawn[i][2 * k], b[i][k] = drawn[i][2 * k + 1];
    }
  }
  void ask_a(Function& function, const Columns& out) { ask(function, out, a, a, 0); }
  void ask_b(Function& function, const Columns& out) { ask(function, out, b, b, 0); }
  void ask_ab(Function& function, const Columns& out, std::size_t input) { ask(function, out, a, b, input); }

 private:
  void ask(Function& function, const Columns& out, const Columns& most, const Columns& one, std::size_t input) {
    for (std::size_t i = 0; i < starts.size(); ++i) starts[i] = i == input ? one[i] : most[i];
    function.evaluate(starts, out.write(), count);
  }

  std::size_t count;
  Columns drawn, a, b;
  std::vector<const double*> starts;
};

}  // namespace

SobolSums::SobolSums(std::size_t inputs, std::vector<double> centres)
    : inputs_(inputs), centres_(std::move(centres)), outputs_(centres_.size()), pairs_(centres_.size() * inputs) {}

void SobolSums::add_row(std::size_t output, double a, double b, std::span<const double> c) {
  OfOutput& all = outputs_[output];
  const bool known = std::isfinite(a) && std::isfinite(b) &&
                     std::all_of(c.begin(), c.end(), [](double value) { return std::isfinite(value); });
  if (!known) {
    ++all.left_out;
    return;
  }
  const double aa = a * a, bb = b * b, v = 0.5 * (aa + bb);
  ++all.rows;
  all.a += a, all.b += b, all.aa += aa, all.bb += bb, all.vv += v * v;
  for (std::size_t i = 0; i < inputs_; ++i) {
    OfInput& one = pairs_[output * inputs_ + i];
    const double cc = c[i] * c[i], bc = b * c[i], t = 0.5 * (a - c[i]) * (a - c[i]);
    one.c += c[i], one.cc += cc, one.bc += bc;
    one.bbbb += bb * bb, one.bbbc += bb * bc, one.bbcc += bc * bc, one.bccc += bc * cc, one.cccc += cc * cc;
    one.t += t, one.tt += t * t, one.tv += t * v;
  }
}

void SobolSums::add(Function& function, const Sampler& sampler, std::uint64_t number, std::uint64_t rows) {
  const std::uint64_t first = number * block;
  const std::size_t n = std::min<std::uint64_t>(block, rows - first), outputs = centres_.size();
  Rows drawn(sampler, inputs_, first, n);
  Columns a(outputs, n), b(outputs, n);
  std::vector<Columns> ab;
  drawn.ask_a(function, a);
  drawn.ask_b(function, b);
  for (std::size_t i = 0; i < inputs_; ++i) drawn.ask_ab(function, ab.emplace_back(outputs, n), i);
  SobolSums here(inputs_, centres_);
  std::vector<double> c(inputs_);
  for (std::size_t o = 0; o < outputs; ++o) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < inputs_; ++i) c[i] = ab[i][o][k] - centres_[o];
      here.add_row(o, a[o][k] - centres_[o], b[o][k] - centres_[o], c);
    }
  }
  merge(here);
}

void SobolSums::merge(const SobolSums& next) {
  for (std::size_t o = 0; o < outputs_.size(); ++o) {
    OfOutput& s = outputs_[o];
    const OfOutput& t = next.outputs_[o];
    s.rows += t.rows, s.left_out += t.left_out;
    s.a += t.a, s.b += t.b, s.aa += t.aa, s.bb += t.bb, s.vv += t.vv;
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    OfInput& s = pairs_[p];
    const OfInput& t = next.pairs_[p];
    s.c += t.c, s.cc += t.cc, s.bc += t.bc;
    s.bbbb += t.bbbb, s.bbbc += t.bbbc, s.bbcc += t.bbcc, s.bccc += t.bccc, s.cccc += t.cccc;
    s.t += t.t, s.tt += t.tt, s.tv += t.tv;
  }
}

/// Both indices with the variance of each row's contribution (delta method), the centre taken for the mean there.
SobolIndex SobolSums::index(const OfOutput& all, const OfInput& one) const {
  const auto n = static_cast<double>(all.rows);
  const double mean = (all.a + all.b) / (2.0 * n), V = (all.aa + all.bb) / (2.0 * n) - mean * mean;
  const double b = all.b / n, c = one.c / n, var_b = all.bb / n - b * b, var_c = one.cc / n - c * c;
  SobolIndex index;
  const double r = (one.bc / n - b * c) / std::sqrt(var_b * var_c), T = one.t / n / V;
  const double uuuu = one.bbbb / n / (var_b * var_b), vvvv = one.cccc / n / (var_c * var_c);
  const double uuvv = one.bbcc / n / (var_b * var_c);
  const double uneven = (one.bbbc / var_b + one.bccc / var_c) / n / std::sqrt(var_b * var_c);
  const double of_r = uuvv - r * uneven + 0.25 * r * r * (uuuu + 2.0 * uuvv + vvvv);
  const double of_T = (one.tt - 2.0 * T * one.tv + T * T * all.vv) / n / (V * V);
  index.first = r, index.first_within = two_sided_95 * std::sqrt(std::max(of_r, 0.0) / n);
  index.total = T, index.total_within = two_sided_95 * std::sqrt(std::max(of_T, 0.0) / n);
  return index;
}

std::vector<SobolIndices> SobolSums::result() const {
  std::vector<SobolIndices> results;
  for (std::size_t o = 0; o < outputs_.size(); ++o) {
    const OfOutput& all = outputs_[o];
    SobolIndices& next = results.emplace_back();
    const auto n = static_cast<double>(all.rows);
    const double mean = (all.a + all.b) / (2.0 * n);
    next.mean = centres_[o] + mean, next.variance = (all.aa + all.bb) / (2.0 * n) - mean * mean;
    next.rows = all.rows, next.left_out = all.left_out;
    const bool scatters = all.rows >= 2 && next.variance > 0.0;
    for (std::size_t i = 0; i < inputs_; ++i)
      next.inputs.push_back(scatters ? index(all, pairs_[o * inputs_ + i]) : SobolIndex{none, none, none, none});
  }
  return results;
}

std::vector<double> sobol_centres(Function& function, const Sampler& sampler) {
  constexpr std::size_t n = SobolSums::block;
  Columns in(function.inputs(), n), out(function.outputs(), n);
  sampler(0, n, in.write());
  function.evaluate(in.read(), out.write(), n);
  std::vector<double> centres;
  for (std::size_t o = 0; o < function.outputs(); ++o) {
    double sum = 0.0, count = 0.0;
    for (const double value : std::span(out[o], n)) {
      if (std::isfinite(value)) sum += value, ++count;
    }
    centres.push_back(count > 0.0 ? sum / count : 0.0);
  }
  return centres;
}

std::vector<SobolIndices> sobol_indices(Function& function, const Sampler& sampler, std::uint64_t rows) {
  SobolSums sums(function.inputs(), sobol_centres(function, sampler));
  for (std::uint64_t number = 0; number * SobolSums::block < rows; ++number) sums.add(function, sampler, number, rows);
  return sums.result();
}

}  // namespace loadpath::sweep
