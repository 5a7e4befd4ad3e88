#include "lib/numerics/sparse_lu.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

using namespace loadpath;

// A random pattern with a full diagonal, and a stream of values in (-1, 1).
class Sample {
 public:
  explicit Sample(std::size_t size, double density) : size_(size) {
    for (std::size_t row = 0; row < size; ++row) {
      for (std::size_t column = 0; column < size; ++column) {
        if (row == column || std::abs(next()) < density) {
          pattern.push_back({static_cast<int>(row), static_cast<int>(column)});
        }
      }
    }
    renew();
  }
  void renew() {
    values.resize(pattern.size());
    for (double& v : values) v = next();
  }
  [[nodiscard]] std::vector<double> times(const std::vector<double>& x, bool transposed) const {
    std::vector<double> b(size_);
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      const auto row = static_cast<std::size_t>(pattern[k].row);
      const auto column = static_cast<std::size_t>(pattern[k].column);
      transposed ? b[column] += values[k] * x[row] : b[row] += values[k] * x[column];
    }
    return b;
  }
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(static_cast<std::int64_t>(state_)) * 0x1p-63;
  }

  std::vector<numerics::MatrixEntry> pattern;
  std::vector<double> values;

 private:
  std::size_t size_;
  std::uint64_t state_ = 42;
};

double error(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

}  // namespace

TEST_SUITE("numerics") {
  TEST_CASE("random sparse systems are solved, straight and transposed, as their values change") {
    for (const std::size_t size : {1U, 2U, 5U, 12U, 40U}) {
      Sample sample(size, 3.0 / static_cast<double>(size));
      numerics::SparseLu lu(size, sample.pattern);
      for (int round = 0; round < 50; ++round) {
        sample.renew();
        std::vector<double> x(size);
        for (double& v : x) v = sample.next();
        REQUIRE(lu.factor(sample.values));
        const double tolerance = 1e-14 / lu.reciprocal_condition(sample.values);
        for (const bool transposed : {false, true}) {
          std::vector<double> b = sample.times(x, transposed);
          transposed ? lu.solve_transposed(b) : lu.solve(b);
          CHECK(error(b, x) <= tolerance);
        }
      }
    }
  }

  TEST_CASE("a pivot that vanishes leads to a new order, not to a failure") {
    const std::vector<numerics::MatrixEntry> pattern{{0, 0}, {0, 1}, {1, 0}, {1, 1}};
    numerics::SparseLu lu(2, pattern);
    REQUIRE(lu.factor(std::vector{1.0, 0.1, 0.1, 1.0}));
    REQUIRE(lu.factor(std::vector{0.0, 2.0, 4.0, 0.0}));
    std::vector b{2.0, 8.0};
    lu.solve(b);
    CHECK(b == std::vector{2.0, 1.0});
  }

  TEST_CASE("a singular matrix is refused, and the next one is solved") {
    const std::vector<numerics::MatrixEntry> pattern{{0, 0}, {0, 1}, {1, 0}, {1, 1}};
    numerics::SparseLu lu(2, pattern);
    CHECK_FALSE(lu.factor(std::vector{1.0, 2.0, 2.0, 4.0}));
    REQUIRE(lu.factor(std::vector{1.0, 2.0, 2.0, 3.0}));
    CHECK_FALSE(lu.factor(std::vector{1.0, 2.0, 2.0, 4.0}));
    REQUIRE(lu.factor(std::vector{1.0, 2.0, 2.0, 3.0}));
    std::vector b{3.0, 5.0};
    lu.solve(b);
    CHECK(error(b, {1.0, 1.0}) < 1e-14);
  }

  TEST_CASE("the condition number of a diagonal matrix is the ratio of its ends") {
    const std::vector<numerics::MatrixEntry> pattern{{0, 0}, {1, 1}, {2, 2}};
    numerics::SparseLu lu(3, pattern);
    const std::vector values{5.0, -0.25, 1.0};
    REQUIRE(lu.factor(values));
    CHECK(lu.reciprocal_condition(values) == doctest::Approx(0.05).epsilon(1e-14));
  }
}
