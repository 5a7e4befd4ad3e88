// A symmetric positive definite matrix with few entries beside its diagonal, factored in place: beams, chains of
// springs.
#pragma once

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace loadpath::numerics {

/// Of at most `most` unknowns. Entries lie at most `reach` beside the diagonal; of them the lower half is kept, row by
/// row.
template <std::size_t reach, std::size_t most>
class BandMatrix {
 public:
  explicit BandMatrix(std::size_t size) : rows_(size) {}

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// The entry of row i and column j, i - reach <= j <= i.
  [[nodiscard]] double& at(std::size_t i, std::size_t j) { return rows_[i][reach + j - i]; }
  [[nodiscard]] double at(std::size_t i, std::size_t j) const { return rows_[i][reach + j - i]; }

  /// Makes row and column i those of the unit matrix: an unknown that is zero.
  void fix(std::size_t i) {
    rows_[i].fill(0.0);
    rows_[i][reach] = 1.0;
    for (std::size_t below = i + 1; below < size() && below <= i + reach; ++below) at(below, i) = 0.0;
  }

  /// L D L^T in place of the matrix. False where a pivot is no larger than `least` of its diagonal: it is not positive
  /// definite, to rounding.
  [[nodiscard]] bool factor(double least = 1e-12) {
    for (std::size_t i = 0; i < size(); ++i) {
      const double diagonal = at(i, i);
      const std::size_t first = i - std::min(i, reach);
      for (std::size_t j = first; j < i; ++j) {
        for (std::size_t k = std::max(first, j - std::min(j, reach)); k < j; ++k) at(i, j) -= at(i, k) * at(j, k);
      }
      for (std::size_t j = first; j < i; ++j) {
        const double scaled = at(i, j) / at(j, j);
        at(i, i) -= scaled * at(i, j);
        at(i, j) = scaled;
      }
      if (!(at(i, i) > least * diagonal)) return false;
    }
    return true;
  }

  /// The solution in place of the right-hand side, after `factor`.
  void solve(std::span<double> x) const {
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t j = i - std::min(i, reach); j < i; ++j) x[i] -= at(i, j) * x[j];
    }
    for (std::size_t i = 0; i < size(); ++i) x[i] /= at(i, i);
    for (std::size_t i = size(); i-- > 0;) {
      for (std::size_t j = i - std::min(i, reach); j < i; ++j) x[j] -= at(i, j) * x[i];
    }
  }

  /// The diagonal of the inverse, after `factor`: what each unknown does where it acts alone. From the last row up, of
  /// the inverse no more than lies within the band.
  void inverse_diagonal(std::span<double> diagonal) const {
    boost::container::static_vector<std::array<double, reach + 1>, most> inverse(size());  // row i: from i to the right
    for (std::size_t i = size(); i-- > 0;) {
      const std::size_t right = std::min(reach, size() - 1 - i);
      inverse[i].fill(0.0);
      for (std::size_t k = right; k > 0; --k) {
        for (std::size_t l = 1; l <= right; ++l)
          inverse[i][k] -= at(i + l, i) * (l <= k ? inverse[i + l][k - l] : inverse[i + k][l - k]);
      }
      inverse[i][0] = 1.0 / at(i, i);
      for (std::size_t l = 1; l <= right; ++l) inverse[i][0] -= at(i + l, i) * inverse[i][l];
      diagonal[i] = inverse[i][0];
    }
  }

 private:
  boost::container::static_vector<std::array<double, reach + 1>, most> rows_;
};

}  // namespace loadpath::numerics
