// The tolerance to be tightened: the variance of an output as a sum of those of the inputs, by its slopes.
#pragma once

#include "lib/sweep/sensitivity/slopes.hpp"

namespace loadpath::sweep {

struct BudgetLine {
  std::size_t input = 0;
  double share = 0.0;     // share of the variance; shares sum to 1, and may be negative if inputs are correlated
  double variance = 0.0;  // variance of the output with this input's standard deviation halved
};

struct Budget {
  double variance = 0.0;          // variance of the output: first order, exact for linear functions
  bool certain = true;            // every slope is smooth
  std::vector<BudgetLine> lines;  // smallest variance after halving first; equal ones in the order of the inputs
};

/// The budget of one output. `sd` has the standard deviation of each input, `correlation` is empty, or the matrix row
/// after row. Where a slope of an input that scatters is not available, so is the variance: NaN. Shares of no variance
/// are NaN.
[[nodiscard]] Budget variance_budget(const Slopes& slopes, std::size_t output, std::span<const double> sd,
                                     std::span<const double> correlation = {});

}  // namespace loadpath::sweep
