// A symmetric positive definite matrix with a narrow band, factored in place: beams, chains of springs.
#pragma once

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace loadpath::numerics {

/// For at most `most` unknowns. The half bandwidth is three, as for elements with two unknowns at each end; the lower
/// half is stored, row by row. Values of earlier rows that a row needs are kept in variables: reading them back right
/// after the store would stall.
template <std::size_t most>
class BandMatrix {
  static constexpr std::size_t reach = 3;
  using Row = std::array<double, reach + 1>;

  /// The values of earlier rows that a row of L D L^T needs.
  struct Before {
    double d1 = 1.0, d2 = 1.0, d3 = 1.0;     // the pivots, from the nearest on
    double l12 = 0.0, l13 = 0.0, l23 = 0.0;  // L: row before to the 2nd, 3rd; 2nd to the 3rd

    /// The next row of L, with its pivot at the end, of a row of the matrix whose diagonal is given.
    Row next(const Row& row, double diagonal) {
      const double a = row[0], b = row[1] - a * l23, c = row[2] - a * l13 - b * l12;
      const double l3 = a / d3, l2 = b / d2, l1 = c / d1;
      const double pivot = diagonal - l3 * a - l2 * b - l1 * c;
      d3 = d2, d2 = d1, d1 = pivot;
      l23 = l12, l13 = l2, l12 = l1;
      return {l3, l2, l1, pivot};
    }
  };

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

  /// Replaces the matrix by L D L^T. False if a pivot is at most `least` of its diagonal: the matrix is not positive
  /// definite, to rounding.
  [[nodiscard]] bool factor(double least = 1e-12) {
    Before before;
    for (Row& row : rows_) {
      const Row next = before.next(row, row[reach]);
      if (!(next[reach] > least * row[reach])) return false;
      row = next;
    }
    return true;
  }

  /// Each pivot in turn of L D L^T of the matrix minus a diagonal, whatever its sign: the number of negative pivots
  /// is that of eigenvalues below. A zero pivot, which occurs only by coincidence, is replaced by a tiny number.
  template <class Less, class Take>
  void for_each_pivot(const Less& less, const Take& take) const {
    Before before;
    for (std::size_t i = 0; i < size(); ++i) {
      const double diagonal = rows_[i][reach] - less(i);
      double& pivot = before.d1;
      before.next(rows_[i], diagonal);
      if (pivot == 0.0) pivot = std::numeric_limits<double>::epsilon() * (diagonal != 0.0 ? diagonal : 1.0);
      take(i, pivot);
    }
  }

  /// Replaces the right-hand side by the solution, after `factor`.
  void solve(std::span<double> x) const { solve_all(std::array{x}); }

  /// Replaces several right-hand sides by their solutions: each unknown waits for the one before, so that two take
  /// hardly longer than one.
  template <std::size_t count>
  void solve_all(const std::array<std::span<double>, count>& all) const {
    using OfEach = std::array<double, count>;
    OfEach x1{}, x2{}, x3{};  // the unknowns before, from the nearest on
    for (std::size_t i = 0; i < size(); ++i) {
      const Row& row = rows_[i];
      for (std::size_t k = 0; k < count; ++k) {
        const double next = all[k][i] - row[0] * x3[k] - row[1] * x2[k] - row[2] * x1[k];
        all[k][i] = next;
        x3[k] = x2[k], x2[k] = x1[k], x1[k] = next;
      }
    }
    x1 = x2 = x3 = OfEach{};
    const auto below = [&](std::size_t i, std::size_t k) { return i + k < size() ? rows_[i + k][reach - k] : 0.0; };
    for (std::size_t i = size(); i-- > 0;) {
      const double pivot = rows_[i][reach], b1 = below(i, 1), b2 = below(i, 2), b3 = below(i, 3);
      for (std::size_t k = 0; k < count; ++k) {
        const double next = all[k][i] / pivot - b3 * x3[k] - b2 * x2[k] - b1 * x1[k];
        all[k][i] = next;
        x3[k] = x2[k], x2[k] = x1[k], x1[k] = next;
      }
    }
  }

  /// The diagonal of the inverse, after `factor`: the response of each unknown to its own unit load. Computed from
  /// the last row up, within the band only.
  void inverse_diagonal(std::span<double> diagonal) const {
    boost::container::static_vector<Row, most> inverse(size());  // row i: from i to the right
    for (std::size_t i = size(); i-- > 0;) {
      const std::size_t right = std::min(reach, size() - 1 - i);
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
  boost::container::static_vector<Row, most> rows_;
};

}  // namespace loadpath::numerics
