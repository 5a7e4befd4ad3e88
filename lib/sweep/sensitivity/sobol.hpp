// Sobol indices: the share of an output's variance due to an input by itself, and the share including its
// interactions.
//
// Samples 2 j and 2 j + 1 of the sampler are the rows A_j and B_j; AB_ij is A_j with input i from B_j (Saltelli 2010).
// The first-order index is the correlation of f(B) and f(AB_i) (Martinez 2011), the total one the mean of (f(A) -
// f(AB_i))^2 / 2 over the variance (Jansen 1999). Inputs are independent of one another.
#pragma once

#include "lib/sweep/function.hpp"
#include "lib/sweep/sensitivity/sampler.hpp"

#include <vector>

namespace loadpath::sweep {

struct SobolIndex {
  double first = 0.0, first_within = 0.0;  // 95 % of such estimates lie within this of the true one
  double total = 0.0, total_within = 0.0;
};

/// The indices of one output. If it does not scatter, or fewer than two rows are known, they are NaN.
struct SobolIndices {
  double mean = 0.0, variance = 0.0;
  std::uint64_t rows = 0;      // j of which all values are finite
  std::uint64_t left_out = 0;  // others
  std::vector<SobolIndex> inputs;
};

/// Sums over rows. Those of blocks, made anywhere and merged in the order of their numbers, have the bits of
/// sobol_indices.
class SobolSums {
 public:
  static constexpr std::size_t block = 256;  // rows

  /// `centres` are near the means of the outputs, and the same for all that is merged.
  SobolSums(std::size_t inputs, std::vector<double> centres);
  /// Rows from block * number on, to below `rows` of all.
  void add(Function& function, const Sampler& sampler, std::uint64_t number, std::uint64_t rows);
  void merge(const SobolSums& next);
  [[nodiscard]] std::vector<SobolIndices> result() const;

 private:
  /// Over values a of f(A) and b of f(B) less the centre.
  struct OfOutput {
    std::uint64_t rows = 0, left_out = 0;
    double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0;
    double vv = 0.0;  // sum of squares of v = (a^2 + b^2) / 2
  };
  /// Over b, c of f(AB_i) and t = (a - c)^2 / 2.
  struct OfInput {
    double c = 0.0, cc = 0.0, bc = 0.0;
    double bbbb = 0.0, bbbc = 0.0, bbcc = 0.0, bccc = 0.0, cccc = 0.0;
    double t = 0.0, tt = 0.0, tv = 0.0;
  };
  void add_row(std::size_t output, double a, double b, std::span<const double> c);
  [[nodiscard]] SobolIndex index(const OfOutput& all, const OfInput& one) const;

  std::size_t inputs_;
  std::vector<double> centres_;
  std::vector<OfOutput> outputs_;
  std::vector<OfInput> pairs_;  // for each output those of all inputs
};

/// Means of the outputs over the first block, finite values only.
[[nodiscard]] std::vector<double> sobol_centres(Function& function, const Sampler& sampler);

/// From `rows` rows, (inputs + 2) evaluations each.
[[nodiscard]] std::vector<SobolIndices> sobol_indices(Function& function, const Sampler& sampler, std::uint64_t rows);

}  // namespace loadpath::sweep
