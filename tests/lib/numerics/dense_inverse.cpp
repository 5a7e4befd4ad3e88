#include "lib/numerics/dense_inverse.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace loadpath;

namespace {

using Matrix = std::vector<double>;  // row after row

/// About a third of its entries are not zero, among them the diagonal's.
Matrix sparse(std::size_t size, std::mt19937_64& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  Matrix a(size * size);
  for (std::size_t n = 0; n < a.size(); ++n) {
    if (n % (size + 1) == 0 || std::abs(entry(random)) < 0.33) a[n] = entry(random);
  }
  return a;
}

Matrix inverse_of(Matrix a, std::size_t size) {
  numerics::DenseInverse(size).invert(a);
  return a;
}

/// The largest entry of a b - 1.
double off_unit(const Matrix& a, const Matrix& b, std::size_t size) {
  double most = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      double sum = i == j ? -1.0 : 0.0;
      for (std::size_t k = 0; k < size; ++k) sum += a[i * size + k] * b[k * size + j];
      most = std::max(most, std::abs(sum));
    }
  }
  return most;
}

}  // namespace

TEST_SUITE("numerics") {
  TEST_CASE("a matrix times its inverse is the unit matrix, on either side, as exact as its condition allows") {
    std::mt19937_64 random(11);
    for (const std::size_t size : {1U, 2U, 3U, 8U, 15U, 40U}) {
      for (int n = 0; n < 20; ++n) {
        const Matrix a = sparse(size, random), inverse = inverse_of(a, size);
        const double condition = numerics::largest_row_sum(a, size) * numerics::largest_row_sum(inverse, size);
        CAPTURE(size);
        CHECK(std::isfinite(condition));
        CHECK(off_unit(a, inverse, size) <= 1e-15 * condition * static_cast<double>(size));
        CHECK(off_unit(inverse, a, size) <= 1e-15 * condition * static_cast<double>(size));
      }
    }
  }

  TEST_CASE("a zero on the diagonal is not an obstacle: rows are exchanged") {
    const Matrix a{0.0, 2.0, 0.0, 0.0, 0.0, 4.0, 8.0, 0.0, 0.0};
    CHECK(inverse_of(a, 3) == Matrix{0.0, 0.0, 0.125, 0.5, 0.0, 0.0, 0.0, 0.25, 0.0});
  }

  TEST_CASE("stored by rows or by columns, the inverse is stored alike") {
    const Matrix a{2.0, 1.0, 0.0, 4.0};
    CHECK(inverse_of(a, 2) == Matrix{0.5, -0.125, 0.0, 0.25});
    CHECK(inverse_of({2.0, 0.0, 1.0, 4.0}, 2) == Matrix{0.5, 0.0, -0.125, 0.25});
  }

  TEST_CASE("a singular matrix has no inverse of finite numbers, and its sums show it") {
    const Matrix a{1.0, 2.0, 2.0, 4.0};
    CHECK(numerics::largest_row_sum(a, 2) == 6.0);
    CHECK_FALSE(std::isfinite(numerics::largest_row_sum(inverse_of(a, 2), 2)));
  }
}
