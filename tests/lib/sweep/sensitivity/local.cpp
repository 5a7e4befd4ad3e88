// Tornado, slopes and budget: what is known at a point.
#include "lib/sweep/sensitivity/tornado.hpp"
#include "lib/sweep/sensitivity/variance_budget.hpp"
#include "tests/lib/sweep/formula.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace loadpath::sweep;
using namespace loadpath::sweep::testing;
using Kind = Slope::Kind;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Slope slope_of(double (*f)(double), double x, double step = 0.0) {
  Formula function(1, 1, [f](const double* in, double* y) { y[0] = f(in[0]); });
  return slopes(function, {x}, std::vector{step}).at(0, 0);
}

}  // namespace

TEST_SUITE("sensitivities at a point") {
  TEST_CASE("the tornado of a linear function is that calculated by hand") {
    Formula line(3, 2, [](const double* x, double* y) {
      y[0] = 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2];
      y[1] = x[1] * x[1];
    });
    const auto all = tornado(line, {1, 0, 4}, {0.5, -1, 2}, {1.5, 1, 8});
    REQUIRE(all.size() == 2);
    CHECK(all[0].base == 4.0);
    REQUIRE(all[0].bars.size() == 3);
    CHECK(all[0].bars[0].input == 1);  // from 7 to 1
    CHECK(all[0].bars[0].low == 7.0);
    CHECK(all[0].bars[0].high == 1.0);
    CHECK(all[0].bars[0].swing == 6.0);
    CHECK(all[0].bars[1].input == 2);  // from 3 to 6
    CHECK(all[0].bars[1].swing == 3.0);
    CHECK(all[0].bars[2].swing == 2.0);
    CHECK_FALSE(all[0].bars[0].turns);
    CHECK(all[1].bars[0].input == 1);
    CHECK(all[1].bars[0].swing == 1.0);  // 1, 0, 1: only the ends would hide it
    CHECK(all[1].bars[0].turns);
    CHECK(line.points == 7);
  }

  TEST_CASE("missing values come first in a tornado") {
    Formula root(2, 1, [](const double* x, double* y) { y[0] = 100.0 * x[0] + std::sqrt(x[1]); });
    const auto all = tornado(root, {1, 1}, {0, -1}, {2, 3});
    CHECK(all[0].bars[0].input == 1);
    CHECK(std::isnan(all[0].bars[0].swing));
    CHECK(all[0].bars[1].swing == 200.0);
  }

  TEST_CASE("slopes of smooth functions have more correct digits than the estimate states") {
    const auto check = [](const Slope& slope, double closed) {
      CHECK(slope.kind == Kind::smooth);
      CHECK(slope.value == doctest::Approx(closed).epsilon(1e-9));
      CHECK(std::abs(slope.value - closed) <= slope.error);
      CHECK(slope.error <= 1e-8 * std::abs(closed));
    };
    check(slope_of([](double x) { return std::exp(x); }, 1.5), std::exp(1.5));
    check(slope_of([](double x) { return 1.0 / (x * x * x); }, 0.04), -3.0 / std::pow(0.04, 4));
    check(slope_of([](double x) { return std::sin(x); }, 0.0), 1.0);
    check(slope_of([](double x) { return 1e6 + 1e3 * x * x; }, 2.0, 0.1), 4e3);
    check(slope_of([](double x) { return -7.0 * x; }, 1e-9), -7.0);
  }

  TEST_CASE("a power has its exponent as elasticity, a constant none") {
    Formula power(2, 2, [](const double* x, double* y) {
      y[0] = 5.0 * std::pow(x[0], 3) / std::sqrt(x[1]);
      y[1] = 8.0;
    });
    const Slopes all = slopes(power, {0.05, 235e6});
    CHECK(all.at(0, 0).elasticity == doctest::Approx(3.0).epsilon(1e-10));
    CHECK(all.at(0, 1).elasticity == doctest::Approx(-0.5).epsilon(1e-10));
    CHECK(all.at(1, 0).kind == Kind::smooth);
    CHECK(all.at(1, 0).value == 0.0);
    CHECK(power.points == 41);
  }

  TEST_CASE("a kink is reported, with the slope of each side") {
    const Slope kink = slope_of([](double x) { return std::max(2.0 * x, x * x); }, 2.0);
    CHECK(kink.kind == Kind::kink);
    CHECK(kink.below == doctest::Approx(2.0).epsilon(1e-9));
    CHECK(kink.above == doctest::Approx(4.0).epsilon(1e-9));
    CHECK(kink.value == doctest::Approx(3.0).epsilon(1e-9));
    CHECK(kink.error == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(slope_of([](double x) { return std::abs(x); }, 0.0).kind == Kind::kink);
    // next to the point, though within the step: smooth there
    const Slope beside = slope_of([](double x) { return std::max(2.0 * x, x * x); }, 1.999);
    CHECK(beside.kind == Kind::smooth);
    CHECK(beside.value == doctest::Approx(2.0).epsilon(1e-9));
  }

  TEST_CASE("where one side is not available the other is used") {
    const Slope edge = slope_of([](double x) { return x < 1.0 ? none : x * x * x; }, 1.0);
    CHECK(edge.kind == Kind::above);
    CHECK(edge.value == doctest::Approx(3.0).epsilon(1e-8));
    CHECK(std::isnan(edge.below));
    CHECK(slope_of([](double x) { return x > 1.0 ? none : x * x * x; }, 1.0).kind == Kind::below);
    CHECK(slope_of([](double x) { return x == 1.0 ? none : x; }, 1.0).kind == Kind::none);
    CHECK(slope_of([](double x) { return x == 1.0 ? x : none; }, 1.0).kind == Kind::none);
    // the far steps leave the range, the near ones do not
    const Slope near = slope_of([](double x) { return x > 1.003 ? none : x * x * x; }, 1.0);
    CHECK(near.kind == Kind::smooth);
    CHECK(near.value == doctest::Approx(3.0).epsilon(1e-8));
  }

  TEST_CASE("a jump and noise do not converge") {
    CHECK(slope_of([](double x) { return x < 1.0 ? 0.0 : 1.0; }, 1.0).kind == Kind::unsettled);
    CHECK(slope_of([](double x) { return std::sqrt(std::abs(x)); }, 0.0).kind == Kind::unsettled);
    CHECK(slope_of([](double x) { return std::sin(1e9 * x); }, 1.0).kind == Kind::unsettled);
    CHECK(slope_of([](double x) { return x + 0.01 * std::sin(1e7 * x); }, 1.0).kind == Kind::unsettled);
  }

  TEST_CASE("the budget of a linear function is that calculated by hand") {
    Formula line(3, 1, [](const double* x, double* y) { y[0] = 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2] + 10.0; });
    const Slopes at = slopes(line, {1, 2, 3});
    const std::vector<double> sd{1.0, 1.0, 4.0};
    const Budget budget = variance_budget(at, 0, sd);
    CHECK(budget.certain);
    CHECK(budget.variance == doctest::Approx(4.0 + 9.0 + 4.0).epsilon(1e-10));
    REQUIRE(budget.lines.size() == 3);
    CHECK(budget.lines[0].input == 1);
    CHECK(budget.lines[0].share == doctest::Approx(9.0 / 17.0).epsilon(1e-10));
    CHECK(budget.lines[0].variance == doctest::Approx(17.0 - 0.75 * 9.0).epsilon(1e-10));
    CHECK(budget.lines[1].variance == doctest::Approx(14.0).epsilon(1e-10));
  }

  TEST_CASE("correlated inputs share their covariance") {
    Formula sum(2, 1, [](const double* x, double* y) { y[0] = x[0] + 2.0 * x[1]; });
    const Slopes at = slopes(sum, {1, 1});
    const std::vector<double> sd{3.0, 1.0}, rho{1.0, -0.5, -0.5, 1.0};
    const Budget budget = variance_budget(at, 0, sd, rho);  // 9 + 4 - 6
    CHECK(budget.variance == doctest::Approx(7.0).epsilon(1e-10));
    CHECK(budget.lines[0].input == 0);
    CHECK(budget.lines[0].share == doctest::Approx(6.0 / 7.0).epsilon(1e-10));
    CHECK(budget.lines[0].variance == doctest::Approx(2.25 + 4.0 - 3.0).epsilon(1e-10));
    CHECK(budget.lines[1].variance == doctest::Approx(9.0 + 1.0 - 3.0).epsilon(1e-10));  // halving it helps nothing
  }

  TEST_CASE("a budget states where it is uncertain or not available") {
    Formula both(2, 2, [](const double* x, double* y) {
      y[0] = std::abs(x[0]) + x[1];
      y[1] = std::sqrt(-1.0 - x[0] * x[0]) + x[1];
    });
    const Slopes at = slopes(both, {0.0, 1.0});
    const std::vector<double> sd{1.0, 1.0}, second{0.0, 1.0};
    CHECK_FALSE(variance_budget(at, 0, sd).certain);
    CHECK(variance_budget(at, 0, second).certain);
    CHECK(variance_budget(at, 0, second).lines[0].variance == doctest::Approx(0.25));
    CHECK(std::isnan(variance_budget(at, 1, sd).variance));
  }
}
