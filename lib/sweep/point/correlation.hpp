// Variables that go together: a correlation matrix of the normal variables behind them (Gaussian copula).
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace loadpath::sweep {

class Correlation {
 public:
  Correlation() = default;

  /// A matrix row after row, for variables with these names. Refused, naming the pair, if not symmetric with a diagonal
  /// of ones, or not positive definite; then with the interval that remains for one coefficient.
  static Outcome<Correlation> of(std::vector<double> matrix, const std::vector<std::string>& names);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Whether a variable goes with any other.
  [[nodiscard]] bool correlated(std::size_t variable) const { return variable < size_ && bound_[variable]; }
  /// Makes columns of n independent standard normal values correlated ones, in place.
  void apply(std::span<double* const> columns, std::size_t n) const;

 private:
  std::size_t size_ = 0;
  std::vector<double> root_;  // Cholesky's lower triangle, row after row
  std::vector<char> bound_;
};

}  // namespace loadpath::sweep
