#include "lib/sweep/sensitivity/robust.hpp"

#include "lib/sweep/search/minimise.hpp"
#include "tests/lib/sweep/formula.hpp"
#include "tests/lib/sweep/sensitivity/numbers.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace loadpath::sweep;
using namespace loadpath::sweep::testing;
using Kind = Statistic::Kind;

namespace {

/// 0, 1, 2, ... in every column.
void counting(std::uint64_t first, std::size_t n, std::span<double* const> columns) {
  for (double* const column : columns) {
    for (std::size_t k = 0; k < n; ++k) column[k] = static_cast<double>(first + k);
  }
}

std::vector<double> values_at(Robust& robust, const std::vector<double>& point) {
  std::vector<const double*> in;
  for (const double& x : point) in.push_back(&x);
  std::vector<double> values(robust.outputs());
  std::vector<double*> out;
  for (double& y : values) out.push_back(&y);
  robust.evaluate(in, out, 1);
  return values;
}

}  // namespace

TEST_SUITE("robust design") {
  TEST_CASE("statistics over 0 to 10 on top of a design variable are those calculated by hand") {
    Formula line(2, 2, [](const double* x, double* y) { y[0] = x[0], y[1] = x[0] + x[1]; });
    Robust robust(
        line, 1, {{0, 0, false}, {{}, 0, false}}, 1, counting, 11,
        {{0, Kind::mean, 0.0}, {0, Kind::deviation, 0.0}, {0, Kind::quantile, 0.25}, {1, Kind::quantile, 0.5}});
    const auto values = values_at(robust, {100.0});
    CHECK(values[0] == 105.0);
    CHECK(values[1] == doctest::Approx(std::sqrt(11.0)));
    CHECK(values[2] == 102.5);
    CHECK(values[3] == 110.0);
  }

  TEST_CASE("scatter may be relative, and failing shares are compared with the allowable share") {
    Formula line(1, 2, [](const double* x, double* y) {
      y[0] = x[0] / 30.0;
      y[1] = x[0] > 45.0 ? std::numeric_limits<double>::quiet_NaN() : x[0] <= 20.0 ? 1.0 : 0.0;
    });
    // 5 (1 + s) with s from 0 to 9: 5, 10, ..., 50
    Robust robust(line, 1, {{0, 0, true}}, 1, counting, 10,
                  {{0, Kind::above_one, 0.5}, {1, Kind::not_one, 0.3}, {1, Kind::mean, 0.0}, {0, Kind::quantile, 1.0}});
    const auto values = values_at(robust, {5.0});
    CHECK(values[0] == doctest::Approx(0.4 / 0.5));
    CHECK(values[1] == doctest::Approx(0.6 / 0.3));
    CHECK(std::isnan(values[2]));
    CHECK(values[3] == doctest::Approx(50.0 / 30.0));
  }

  TEST_CASE("a design may have samples of its own") {
    Formula line(2, 1, [](const double* x, double* y) { y[0] = x[0] + x[1]; });
    Robust robust(line, 1, {{0, {}, false}, {{}, 0, false}}, 1, counting, 11, {{0, Kind::mean, 0.0}},
                  [](std::span<const double> design) { return design[0] > 1.0 ? 100U : 0U; });
    CHECK(values_at(robust, {1.0})[0] == 6.0);
    CHECK(values_at(robust, {2.0})[0] == 107.0);  // 100 to 110
    CHECK(values_at(robust, {1.0})[0] == 6.0);
  }

  TEST_CASE("a point has the same bits alone and among others") {
    Formula square(1, 1, [](const double* x, double* y) { y[0] = std::sin(x[0]) * x[0]; });
    Robust robust(square, 1, {{0, 0, false}}, 1, uniform_samples(4, -0.1, 0.1), 100, {{0, Kind::quantile, 0.9}});
    const std::vector<double> points{0.5, 1.0, 1.5};
    std::vector<double> together(3);
    const double* const in[] = {points.data()};
    double* const out[] = {together.data()};
    robust.evaluate(in, out, 3);
    for (std::size_t k = 0; k < 3; ++k) CHECK(values_at(robust, {points[k]})[0] == together[k]);
  }

  // f = d^2 + 4 (s / d)^2 with s uniform in +-1: its p-quantile is d^2 + 4 q / d^2, q the quantile of s^2 = p^2; least
  // at d = (4 q)^(1/4), where it is 4 sqrt(q) = 4 p.
  TEST_CASE("the minimum quantile is at the position of the closed form, and elsewhere than without scatter") {
    Formula spread(2, 1, [](const double* x, double* y) { y[0] = x[0] * x[0] + 4.0 * x[1] * x[1] / (x[0] * x[0]); });
    constexpr double p = 0.95;
    Robust robust(spread, 1, {{0, {}, false}, {{}, 0, false}}, 1, uniform_samples(11, -1.0, 1.0), 4000,
                  {{0, Kind::quantile, p}});
    Variable d;
    d.from = 0.1, d.to = 5.0;
    Effort effort;
    effort.starts = 2;
    const Optimum found = minimise({robust, {d}, 0, false, {}}, effort);
    CHECK(found.outputs[0] == doctest::Approx(4.0 * p).epsilon(0.01));  // sd of the quantile: 0.0034
    CHECK(found.point[0] == doctest::Approx(std::sqrt(2.0 * p)).epsilon(0.01));
    CHECK(found.neighbours.size() == 2);
  }

  // A bar of diameter d from the stock with d +- 0.5 mm uniform and a load: the share that fails is closed.
  TEST_CASE("the smallest stock size of which enough samples pass") {
    Formula bar(1, 2, [](const double* x, double* y) { y[0] = x[0], y[1] = 400.0 / (x[0] * x[0]); });
    Robust robust(bar, 1, {{0, 0, false}}, 1, uniform_samples(5, -0.5, 0.5), 2000,
                  {{0, Kind::mean, 0.0}, {1, Kind::above_one, 0.12}});
    Variable d;
    d.values = {19.0, 19.5, 20.0, 20.3, 20.4, 20.5, 21.0};  // below 20 mm it fails: 20.3 in 20 %, 20.4 in 10 %
    const Optimum found = minimise({robust, {d}, 0, false, {{1, Constraint::Kind::at_most_one}}});
    CHECK(found.point[0] == 20.4);
    REQUIRE(found.neighbours.size() == 2);
    CHECK(found.neighbours[0].outcome == Neighbour::Outcome::breaks);
    CHECK(found.neighbours[1].outcome == Neighbour::Outcome::no_better);
  }
}
