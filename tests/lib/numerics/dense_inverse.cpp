#include "lib/numerics/dense_inverse.hpp"

#include <Eigen/LU>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace loadpath;

namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// About a third of its entries are not zero, among them the diagonal's.
Matrix sparse(std::size_t size, std::mt19937_64& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const auto n = static_cast<Eigen::Index>(size);
  Matrix a = Matrix::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (i == j || std::abs(entry(random)) < 0.33) a(i, j) = entry(random);
    }
  }
  return a;
}

Matrix inverse_of(const Matrix& a) {
  Matrix inverse = a;
  DenseInverse(static_cast<std::size_t>(a.rows())).invert({inverse.data(), static_cast<std::size_t>(inverse.size())});
  return inverse;
}

}  // namespace

TEST_SUITE("numerics") {
  TEST_CASE("a matrix times its inverse is the unit matrix, as exact as its condition allows") {
    std::mt19937_64 random(11);
    for (const std::size_t size : {1U, 2U, 3U, 8U, 15U, 40U}) {
      for (int n = 0; n < 20; ++n) {
        const Matrix a = sparse(size, random), inverse = inverse_of(a);
        const Matrix reference = a.fullPivLu().inverse();
        const double condition = a.norm() * reference.norm();
        CAPTURE(size);
        CHECK((a * inverse - Matrix::Identity(a.rows(), a.cols())).norm() <=
              1e-14 * condition * static_cast<double>(size));
        CHECK((inverse - reference).norm() <= 1e-14 * condition * reference.norm() * static_cast<double>(size));
      }
    }
  }

  TEST_CASE("a zero on the diagonal is no obstacle: rows change places") {
    Matrix a(3, 3);
    a << 0.0, 2.0, 0.0, 0.0, 0.0, 4.0, 8.0, 0.0, 0.0;
    Matrix expected(3, 3);
    expected << 0.0, 0.0, 0.125, 0.5, 0.0, 0.0, 0.0, 0.25, 0.0;
    CHECK(inverse_of(a) == expected);
  }

  TEST_CASE("a singular matrix has no inverse of finite numbers, and its sums tell it") {
    Matrix a(2, 2);
    a << 1.0, 2.0, 2.0, 4.0;
    const Matrix inverse = inverse_of(a);
    CHECK_FALSE(std::isfinite(largest_row_sum({inverse.data(), 4}, 2)));
    CHECK(largest_row_sum({a.data(), 4}, 2) == 6.0);
  }
}
