#include "lib/sweep/sensitivity/sobol.hpp"

#include "tests/lib/sweep/formula.hpp"
#include "tests/lib/sweep/sensitivity/numbers.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace loadpath::sweep;
using namespace loadpath::sweep::testing;
using std::numbers::pi;

namespace {

/// Ishigami and Homma 1990 with a = 7, b = 0.1; inputs from -pi to pi.
void ishigami(const double* x, double* y) {
  y[0] = std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

struct Shares {
  double first, total;
};

/// In closed form, by the integrals of the terms.
std::array<Shares, 3> shares_of_ishigami() {
  const double a = 7.0, b = 0.1, p4 = std::pow(pi, 4), p8 = p4 * p4;
  const double V1 = 0.5 * std::pow(1.0 + b * p4 / 5.0, 2), V2 = a * a / 8.0, V13 = b * b * p8 * (1.0 / 18 - 1.0 / 50);
  const double V = V1 + V2 + V13;
  return {{{V1 / V, (V1 + V13) / V}, {V2 / V, V2 / V}, {0.0, V13 / V}}};
}

void check(const SobolIndex& index, const Shares& closed) {
  CHECK(index.first == doctest::Approx(closed.first).epsilon(2.0 * index.first_within).scale(1.0));
  CHECK(index.total == doctest::Approx(closed.total).epsilon(2.0 * index.total_within).scale(1.0));
}

}  // namespace

TEST_SUITE("Sobol indices") {
  TEST_CASE("those of Ishigami's function are the closed-form ones") {
    Formula function(3, 1, ishigami);
    const std::uint64_t rows = 20'000;
    const auto found = sobol_indices(function, uniform_samples(1, -pi, pi), rows);
    REQUIRE(found.size() == 1);
    CHECK(function.points == 5 * rows + SobolSums::block);
    CHECK(found[0].rows == rows);
    CHECK(found[0].left_out == 0);
    CHECK(found[0].mean == doctest::Approx(3.5).epsilon(0.02));
    CHECK(found[0].variance == doctest::Approx(13.844588).epsilon(0.02));
    const auto closed = shares_of_ishigami();
    CHECK(closed[0].first == doctest::Approx(0.3139).epsilon(2e-4));
    CHECK(closed[0].total == doctest::Approx(0.5576).epsilon(2e-4));
    CHECK(closed[1].first == doctest::Approx(0.4424).epsilon(2e-4));
    CHECK(closed[2].total == doctest::Approx(0.2437).epsilon(2e-4));
    for (std::size_t i = 0; i < 3; ++i) check(found[0].inputs[i], closed[i]);
    for (const SobolIndex& index : found[0].inputs) CHECK(index.first_within < 0.02);
  }

  // Saltelli and Sobol 1995: V_i = 1 / (3 (1 + a_i)^2) of each factor, which multiply.
  TEST_CASE("those of the g-function are the closed-form ones") {
    constexpr std::array a{0.0, 1.0, 4.5, 9.0, 99.0, 99.0};
    Formula function(6, 2, [&](const double* x, double* y) {
      y[0] = 1.0;
      for (std::size_t i = 0; i < a.size(); ++i) y[0] *= (std::abs(4.0 * x[i] - 2.0) + a[i]) / (1.0 + a[i]);
      y[1] = 3.0 - 2.0 * x[4];
    });
    const auto found = sobol_indices(function, uniform_samples(7), 20'000);
    double all = 1.0;
    for (const double a_i : a) all *= 1.0 + 1.0 / (3.0 * (1.0 + a_i) * (1.0 + a_i));
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double V_i = 1.0 / (3.0 * (1.0 + a[i]) * (1.0 + a[i]));
      check(found[0].inputs[i], {V_i / (all - 1.0), V_i * all / (1.0 + V_i) / (all - 1.0)});
    }
    CHECK(found[1].inputs[4].first == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(found[1].inputs[4].total == doctest::Approx(1.0).epsilon(0.03));
    CHECK(found[1].inputs[0].total == 0.0);
    CHECK(found[1].variance == doctest::Approx(4.0 / 12.0).epsilon(0.02));
  }

  TEST_CASE("the stated intervals contain the closed-form values in 95 of 100 runs") {
    const auto closed = shares_of_ishigami();
    int held_first = 0, held_total = 0;
    constexpr int runs = 400;
    for (int seed = 0; seed < runs; ++seed) {
      Formula function(3, 1, ishigami);
      const auto found =
          sobol_indices(function, uniform_samples(1000 + static_cast<std::uint64_t>(seed), -pi, pi), 512);
      for (std::size_t i = 0; i < 3; ++i) {
        const SobolIndex& index = found[0].inputs[i];
        held_first += std::abs(index.first - closed[i].first) <= index.first_within ? 1 : 0;
        held_total += std::abs(index.total - closed[i].total) <= index.total_within ? 1 : 0;
      }
    }
    for (const int held : {held_first, held_total}) {
      CHECK(held >= 0.93 * 3 * runs);  // 95 % of 1200: three standard deviations are 1.9 %
      CHECK(held <= 0.97 * 3 * runs);
    }
  }

  TEST_CASE("blocks computed anywhere and merged in their order have the same bits") {
    Formula function(3, 1, ishigami);
    const auto sampler = uniform_samples(3, -pi, pi);
    const std::uint64_t rows = 1000;
    const auto whole = sobol_indices(function, sampler, rows);
    const auto centres = sobol_centres(function, sampler);
    std::vector<SobolSums> parts(4, SobolSums(3, centres));
    for (const std::uint64_t number : {2, 0, 3, 1}) parts[number].add(function, sampler, number, rows);
    SobolSums sums(3, centres);
    for (const SobolSums& part : parts) sums.merge(part);
    const auto merged = sums.result();
    CHECK(merged[0].rows == rows);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(merged[0].inputs[i].first == whole[0].inputs[i].first);
      CHECK(merged[0].inputs[i].total == whole[0].inputs[i].total);
      CHECK(merged[0].inputs[i].first_within == whole[0].inputs[i].first_within);
      CHECK(merged[0].inputs[i].total_within == whole[0].inputs[i].total_within);
    }
  }

  TEST_CASE("a large mean costs no digits") {
    Formula near(3, 1, ishigami), far(3, 1, [](const double*x, double*y) {
      ishigami(x, y);
      y[0] += 1e9;
    });
    const auto a = sobol_indices(near, uniform_samples(5, -pi, pi), 2000);
    const auto b = sobol_indices(far, uniform_samples(5, -pi, pi), 2000);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(b[0].inputs[i].first == doctest::Approx(a[0].inputs[i].first).epsilon(1e-6));
  }

  TEST_CASE("rows that are not available are left out and counted; constant outputs have no indices") {
    Formula function(2, 2, [](const double* x, double* y) {
      y[0] = x[0] > 0.9 ? std::numeric_limits<double>::quiet_NaN() : x[0] + x[1];
      y[1] = 4.0;
    });
    const auto found = sobol_indices(function, uniform_samples(2), 5000);
    CHECK(found[0].rows + found[0].left_out == 5000);
    CHECK(found[0].left_out == doctest::Approx(0.19 * 5000).epsilon(0.1));  // neither A nor B above 0.9
    CHECK(std::isfinite(found[0].inputs[1].total));
    CHECK(std::isnan(found[1].inputs[0].first));
    CHECK(std::isnan(found[1].inputs[0].total));
    CHECK(found[1].mean == 4.0);
  }
}
